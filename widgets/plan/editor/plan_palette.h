// List of what plans of a robot can be made of: its senses and acts, and the competences, patterns and adopts of the
// plan itself.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include "core/agent/posh/posh_primitive.h"
#include "core/posh/model/plan.h"
#include "widgets/models/plan/plan_gestures.h"
#include "widgets/plan/editor/plan_code_edit.h"

class QMimeData;

namespace usar::widgets {

/// Drag format between palette and drawing: a piece as `mimeOf` writes it.
inline constexpr const char* plan_piece_mime_type = "application/x-usar-plan-piece";
/// The caller owns the data.
QMimeData* mimeOf(const PlanPiece& piece);
/// The piece in the data; nullopt if there is none.
std::optional<PlanPiece> pieceOf(const QMimeData& data);

/// A search line above a grouped list, and an explanation of the selected piece below it. Pieces are dragged from the
/// list, or added by double-click or Return. GUI thread.
class PlanPalette : public QWidget {
    Q_OBJECT
public:
    explicit PlanPalette(QWidget* parent = nullptr);

    /// The robot's senses and acts; those that every robot has are always listed.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    /// Lists the forms of this plan.
    void setPlan(const posh::Plan& plan);
    /// The names of all pieces, sorted, for completion.
    std::vector<PlanWord> words() const;
    /// The selected piece; nullopt: none.
    std::optional<PlanPiece> chosen() const;

    QSize sizeHint() const override { return {220, 400}; }

signals:
    /// The user wants to add this piece at the selected part.
    void pieceRequested(const usar::widgets::PlanPiece& piece);
    /// The plan's own parts, or those of the robot, have changed.
    void wordsChanged();

private:
    struct Entry {
        QString name;
        QString help;
        PlanPiece piece;
        bool operator==(const Entry&) const = default;
    };
    void rebuild();
    void applyFilter();
    void explain();

    QLineEdit* search_;
    QTreeWidget* list_;
    QLabel* help_;
    std::array<std::vector<Entry>, 5> groups_; ///< senses, acts, competences, action patterns, adopts
};

} // namespace usar::widgets
