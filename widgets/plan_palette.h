// What plans of a robot can be made of: its senses and acts, and the competences, patterns and adopts of the plan
// itself.
#pragma once

#include <optional>
#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include "core/agent/posh_primitive.h"
#include "core/posh/plan.h"
#include "widgets/models/plan_gestures.h"
#include "widgets/plan_code_edit.h"

class QMimeData;

namespace usar::widgets {

/// The drag format between palette and drawing: a piece as `mimeOf` writes it.
inline constexpr const char* plan_piece_mime_type = "application/x-usar-plan-piece";
QMimeData* mimeOf(const PlanPiece& piece);
/// Nothing for what is none.
std::optional<PlanPiece> pieceOf(const QMimeData& data);

/// "Distance($beam=0): a number in m. How far the next thing is": what is known of a sense or act, in sentences.
QString helpText(const agent::PrimitiveDescription& primitive);
/// As a plan asks it first: a truth value as it is, a number compared with 0, of several symbols the first.
QString firstTest(const agent::PrimitiveDescription& sense);

/// A search line over a list in groups, and what is chosen explained below it. Pieces are dragged from it, or added by
/// double-click and Return. GUI thread.
class PlanPalette : public QWidget {
    Q_OBJECT
public:
    explicit PlanPalette(QWidget* parent = nullptr);

    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    void setPlan(const posh::Plan& plan);
    /// All that can be written, for completion: the palette's pieces.
    std::vector<PlanWord> words() const;
    void setFilter(const QString& words);
    std::optional<PlanPiece> chosen() const;

    QSize sizeHint() const override { return {220, 400}; }

signals:
    void pieceRequested(const usar::widgets::PlanPiece& piece);
    /// The plan's own parts or the robot's are others now.
    void wordsChanged();

private:
    struct Entry {
        QString name;
        QString help;
        PlanPiece piece;
    };
    QTreeWidgetItem* group(const QString& title, const char* icon_name, const std::vector<Entry>& entries);
    void rebuild();
    void applyFilter();
    void explain();

    QLineEdit* search_;
    QTreeWidget* list_;
    QLabel* help_;
    std::vector<Entry> senses_;
    std::vector<Entry> acts_;
    std::vector<Entry> competences_;
    std::vector<Entry> patterns_;
    std::vector<Entry> adopts_;
};

} // namespace usar::widgets
