// The drawing of a plan that is edited, below a line that says whether it is out of date.
#pragma once

#include <QLabel>
#include <QWidget>

#include "widgets/models/plan/plan_checker.h"
#include "widgets/plan/editor/plan_part_editor.h"

namespace usar::widgets {

/// GUI thread.
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
