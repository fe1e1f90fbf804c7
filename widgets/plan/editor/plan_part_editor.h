// Edits of the selected part of a drawn plan: by commands, in place, in a dialog, and by drag and drop.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QLabel>
#include <QObject>
#include <QWidget>

#include "core/agent/posh/posh_primitive.h"
#include "core/posh/edit/plan_edits.h"
#include "widgets/models/plan/plan_checker.h"
#include "widgets/plan/editor/plan_canvas.h"
#include "widgets/plan/editor/plan_code_edit.h"

namespace usar::widgets {

/// Owns the plan that the drawing shows, with the text it was read from. Edits nothing itself: it asks for an edit by
/// editRequested, which the editor must perform at once. Nothing can be edited while the text has changed since it was
/// drawn, or cannot be read. GUI thread.
class PlanPartEditor : public QObject {
    Q_OBJECT
public:
    /// The property that a line editor over a part of the drawing changes.
    enum class InPlace { Words, Rename, Trigger, Limit, Comment };

    /// `canvas` and `text` must outlive it; `owner` is the parent of dialogs.
    PlanPartEditor(PlanCanvas& canvas, const PlanCodeEdit& text, QWidget* owner);

    /// The robot's senses and acts, which describe the values of calls.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) { primitives_ = primitives; }
    /// Draws the plan that was read from the current text; a plan that is not readable cannot be edited.
    void draw(const posh::Plan& plan, bool is_readable);

    /// The drawn plan and its text, which is empty if the text was not readable.
    const posh::Plan& plan() const { return plan_; }
    const std::string& drawnText() const { return drawn_text_; }
    /// True if the text has not changed since it was drawn.
    bool isDrawn() const { return drawn_text_ == text_.planText(); }
    /// The possible edits of the drawing; nullptr while nothing can be edited.
    const PlanGestures* gestures() const { return gestures_ && isDrawn() ? &*gestures_ : nullptr; }
    std::optional<posh::PlanPart> selectedPart() const { return partOfNode(plan_, canvas_.tree(), canvas_.selected()); }
    std::optional<posh::PlanPart> selectedCall() const { return callOfNode(plan_, canvas_.tree(), canvas_.selected()); }
    /// The selected call, or else the selected part.
    std::optional<posh::PlanPart> selectedCallOrPart() const;

    /// Edits the selected part by a function of plan_edits.h. If the part is a form called in a pattern, the step is
    /// meant.
    void perform(const std::function<Result<posh::PlanEdit>(const std::string&, const posh::PlanPart&)>& edit);
    /// Opens the line editor with a name, a call or a sense as the plan writes it, the trigger, a limit or a comment.
    void editInPlace(InPlace what);
    void editValues();
    /// Adds a member beside a member, a step beside a step, or a part inside a form; then the user can write its act.
    void addMember(bool before);
    void addPiece(const PlanPiece& piece);
    void addForm(posh::FormKind kind, const std::string& base_name);
    /// Wraps the selected parts in a new form.
    void wrap(posh::FormKind kind);
    /// Replaces the selected call by the content of the form that it calls.
    void inlineSelected();
    /// Remembers the first part by its place in the text until the text changes; swaps the second part with it.
    void swap();

signals:
    /// The receiver must replace the text by that of the edit, and select the edited part.
    void editRequested(const usar::posh::PlanEdit& edit);
    /// The user is about to edit in the drawing, so it should be visible.
    void drawingWanted();
    void said(const QString& words, bool refused);

private:
    /// The part of a node; for a form called in a pattern, the step that calls it.
    std::optional<posh::PlanPart> partMeant(PlanNodeId node) const;
    /// Requests an edit, or says why it is impossible.
    void perform(const Result<posh::PlanEdit>& edit);
    void enterWords(PlanNodeId node, const QString& entered, int what);
    agent::PrimitiveDescription describe(const posh::Call& call) const;

    PlanCanvas& canvas_;
    const PlanCodeEdit& text_;
    QWidget* owner_;
    std::vector<agent::PrimitiveDescription> primitives_;
    posh::Plan plan_;
    std::string drawn_text_;
    std::optional<PlanGestures> gestures_;     ///< gestures for the drawn plan; nullopt if it cannot be edited
    std::optional<posh::PlanPart> swap_first_; ///< first part to swap; valid while the drawn text is swap_text_
    std::string swap_text_;
};

/// The drawing below a line that says whether it is out of date. GUI thread.
class PlanDrawingPane : public QWidget {
    Q_OBJECT
public:
    /// `text` must outlive it; `editor` is its parent and that of dialogs.
    PlanDrawingPane(const PlanCodeEdit& text, QWidget* editor);

    PlanCanvas& canvas() { return *canvas_; }
    PlanPartEditor& parts() { return *parts_; }
    /// Draws the plan that was read from the current text. If the text cannot be read, the last readable plan stays,
    /// because a missing parenthesis would remove half of the drawing. Returns false if the drawing stays.
    bool draw(const PlanChecker& checked);

private:
    QLabel* stale_;
    PlanCanvas* canvas_;
    PlanPartEditor* parts_;
};

} // namespace usar::widgets
