// Panel for editing the world: a palette of object classes, the list of objects, and actions on them.
#pragma once

#include <optional>
#include <vector>

#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <QWidget>

#include "core/protocol/commands/trace.h"
#include "widgets/models/map/object_list_model.h"
#include "widgets/panels/quantity_box.h"

class QAction;

namespace usar::widgets {

class EmptyState;

/// A class of objects that the server can make; `size_m` is its size at a scale of 1.
struct PaletteKind {
    QString class_name;
    QString icon{}; ///< name for icons.h
    ObjectForm form = ObjectForm::Box;
    Vec3 size_m = Vec3::Ones();
    bool conveyor = false; ///< it has a belt instead of way points
};

/// The object that the next click on the map would place: its class, with the chosen size instead of that of the kind.
struct PaletteChoice : PaletteKind {
    /// Factor per axis relative to the size of the kind.
    Vec3 scale = Vec3::Ones();

    /// The object that it would place, for previews.
    MapObject object() const;
};

/// State comes in by setters, choices go out by signals. The user presses a button of the palette and clicks on the
/// map, or drags the button there. GUI thread.
class WorldPanel : public QWidget {
    Q_OBJECT
public:
    explicit WorldPanel(QWidget* parent = nullptr);

    /// Replaces the palette; the first kinds come first.
    void setKinds(const std::vector<PaletteKind>& kinds);
    /// Sets the buttons for actions on the selected object, on its way, and for the robot's trace; nullptr makes a gap.
    /// A button shows the action's iconText below its icon. The actions must outlive the panel.
    void setActions(const std::vector<QAction*>& object, const std::vector<QAction*>& way, QAction* trace);
    /// Replaces all objects; the selection stays with its object.
    void setObjects(const std::vector<MapObject>& objects);
    /// Emits nothing; an empty or unknown name clears the selection.
    void selectObject(const QString& name);
    /// Covers the panel with the reason why no object can be placed; an empty `title` removes it.
    void setTrouble(const QString& title, const QString& hint);

    /// The chosen class and size; nullopt while no button of the palette is pressed and no other class is typed.
    std::optional<PaletteChoice> choice() const;
    /// Releases the button of the palette and clears the typed class.
    void disarm();
    /// Speed along the way, or of the belt; negative runs a belt backward.
    double speed_m_s() const { return speed_->value(); }
    /// True if the way should start again at its first way point.
    bool loop() const { return loop_->isChecked(); }
    /// Emits nothing.
    void setTraceColor(protocol::TraceColor color) { trace_color_->setCurrentIndex(static_cast<int>(color)); }
    protocol::TraceColor traceColor() const { return static_cast<protocol::TraceColor>(trace_color_->currentIndex()); }
    /// The objects as last set, sorted by name.
    const ObjectListModel& model() const { return *model_; }
    QSize sizeHint() const override { return {260, 420}; }

signals:
    /// Another class or size was chosen, or none.
    void choiceChanged();
    /// By the user; empty: none.
    void objectSelected(const QString& name);
    /// The user pressed Delete in the list.
    void removeRequested(const QString& name);
    /// The user chose the color of future trace marks.
    void traceColorChosen(usar::protocol::TraceColor color);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Makes the list of objects, with a sheet that says how to place the first one.
    void makeList();
    /// Makes the editors of length, width and height, in meters; disabled while no kind is chosen.
    QHBoxLayout* makeSizeRow();
    /// Makes the editor of the speed in m/s and the button for starting over.
    QHBoxLayout* makeWayRow();
    QHBoxLayout* makeTraceRow();
    /// Selects a kind by its index and shows its size; -1: none. Emits choiceChanged.
    void choose(int kind);
    /// Chooses the button's kind, lets the user drag it to the map, and disarms after the drop.
    void drag(QToolButton* button);

    std::vector<PaletteKind> kinds_;
    /// The kind whose button is pressed; nullptr if there is none.
    const PaletteKind* chosen_ = nullptr;
    QGridLayout* palette_ = new QGridLayout;
    QButtonGroup* buttons_ = new QButtonGroup(this);
    QLineEdit* other_class_ = new QLineEdit(this);
    /// Along the object's own axes; the first one is also the diameter of round objects.
    QuantityBox* size_m_[3];
    ObjectListModel* model_ = new ObjectListModel(this);
    QTreeView* list_ = new QTreeView(this);
    EmptyState* empty_list_;
    QHBoxLayout* object_row_ = new QHBoxLayout;
    QHBoxLayout* way_row_;
    QuantityBox* speed_;
    QToolButton* loop_;
    QToolButton* trace_;
    QComboBox* trace_color_;
    EmptyState* trouble_;
    /// Place in the button at which the mouse was pressed; a drag begins some pixels from it.
    QPoint pressed_at_;
    bool quiet_ = false; ///< the program changes the selection, not the user
};

} // namespace usar::widgets
