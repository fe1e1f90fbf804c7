#include "widgets/plan/editor/plan_drawing_pane.h"

#include <algorithm>

#include "widgets/plan/plan_parts.h"

namespace usar::widgets {

PlanDrawingPane::PlanDrawingPane(const PlanCodeEdit& text, QWidget* editor) : QWidget(editor) {
    auto* column = makeColumn(this);
    stale_ = makeLabel(this, "caution");
    stale_->hide();
    canvas_ = new PlanCanvas(this);
    canvas_->setMinimumSize(120, 100);
    column->addWidget(stale_);
    column->addWidget(canvas_, 1);
    parts_ = new PlanPartEditor(*canvas_, text, editor);
}

bool PlanDrawingPane::draw(const PlanChecker& checked) {
    const posh::Findings& findings = checked.findings();
    const bool readable = isReadable(findings);
    const bool keeps = !readable && !canvas_->tree().empty() && !parts_->drawnText().empty();
    stale_->setVisible(!readable);
    if (!readable) {
        const auto first =
            std::ranges::find_if(findings, [](const auto& finding) { return isUnreadable(finding.code); });
        stale_->setText(
            keeps ? tr("The drawing shows the plan before the error in line %1.").arg(first->at.line)
                  : tr("Only the readable parts are drawn; there is an error in line %1.").arg(first->at.line));
    }
    if (!keeps)
        parts_->draw(checked.plan(), readable);
    return !keeps;
}

} // namespace usar::widgets
