// The palette of the world: what can be put into it, what is in it, and what can be done with that.
#pragma once

#include <optional>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTreeView>
#include <QWidget>

#include "core/protocol/commands/trace.h"
#include "widgets/models/object_list_model.h"
#include "widgets/quantity_box.h"

class QAction;
class QButtonGroup;
class QGridLayout;
class QHBoxLayout;
class QToolButton;

namespace usar::widgets {

class EmptyState;

/// A class that the server can make, with its size at a scale of 1.
struct PaletteKind {
    QString class_name;
    QString icon;
    ObjectForm form = ObjectForm::Box;
    Vec3 size_m = Vec3::Ones();
    bool conveyor = false;
};

/// What the next click on the map brings.
struct PaletteChoice {
    QString class_name;
    Vec3 size_m = Vec3::Ones();
    Vec3 scale = Vec3::Ones();
    ObjectForm form = ObjectForm::Box;
    bool conveyor = false;
};

/// Values in by setters, choices out by signals. A button of the palette is pressed and then the map clicked, or it is
/// dragged there. GUI thread.
class WorldPanel : public QWidget {
    Q_OBJECT
public:
    explicit WorldPanel(QWidget* parent = nullptr);

    void setKinds(const std::vector<PaletteKind>& kinds);
    /// Buttons for what can be done with the selected object, for its way, and for the robot's trace; nullptr is a gap.
    void setActions(const std::vector<QAction*>& object, const std::vector<QAction*>& way, QAction* trace);
    void setObjects(const std::vector<MapObject>& objects);
    /// Silent; an empty name selects none.
    void selectObject(const QString& name);
    /// Why nothing can be put into the world; empty while it can.
    void setTrouble(const QString& title, const QString& hint);

    /// Nothing while no button of the palette is down.
    std::optional<PaletteChoice> choice() const;
    /// As a drag of it would bring it.
    void disarm();
    double speed_m_s() const { return speed_->value(); }
    bool loop() const;
    /// Silent.
    void setTraceColor(protocol::TraceColor color);
    protocol::TraceColor traceColor() const;
    const ObjectListModel& model() const { return *model_; }
    QSize sizeHint() const override { return {260, 420}; }

signals:
    /// Another kind or size, or none.
    void choiceChanged();
    /// By the person; empty for none.
    void objectSelected(const QString& name);
    void removeRequested(const QString& name);
    void traceColorChosen(usar::protocol::TraceColor color);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeList();
    QHBoxLayout* makeSizeRow();
    QHBoxLayout* makeWayRow();
    QHBoxLayout* makeTraceRow();
    void choose(int kind);
    void drag(QToolButton* button);
    void requestRemoval();
    const PaletteKind* chosen() const;

    std::vector<PaletteKind> kinds_;
    QGridLayout* palette_;
    QButtonGroup* buttons_;
    QLineEdit* other_class_;
    QuantityBox* size_m_[3];
    ObjectListModel* model_;
    QTreeView* list_;
    EmptyState* empty_list_;
    QHBoxLayout* object_row_;
    QHBoxLayout* way_row_;
    QuantityBox* speed_;
    QToolButton* loop_;
    QToolButton* trace_;
    QComboBox* trace_color_;
    EmptyState* trouble_;
    QPoint pressed_at_;
    bool quiet_ = false; ///< a change of the selection is ours, not the person's
};

} // namespace usar::widgets
