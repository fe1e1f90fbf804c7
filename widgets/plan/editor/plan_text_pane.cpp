#include "widgets/plan/editor/plan_text_pane.h"

#include <QMenu>
#include <QTextDocument>

#include "widgets/plan/plan_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int lamp_after_ms = 300;

} // namespace

PlanTextPane::PlanTextPane(QWidget* parent) : QWidget(parent) {
    auto* column = makeColumn(this);
    edit_ = new PlanCodeEdit(this);
    edit_->setMinimumSize(120, 80);
    edit_->setContextMenuPolicy(Qt::CustomContextMenu);
    column->addWidget(edit_, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(gap::tiny);
    finding_ = makeLabel(this);
    finding_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    fix_ = makeToolButton(tr("Offers fixes for this (Alt+Return)"), this, QStringLiteral("lamp"));
    fix_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fix_->setText(tr("Fix"));
    row->addWidget(finding_, 1);
    row->addWidget(fix_, 0, Qt::AlignTop);
    column->addLayout(row);
    lamp_timer_.setSingleShot(true);
    lamp_timer_.setInterval(lamp_after_ms);
    connect(fix_, &QToolButton::clicked, this, &PlanTextPane::fixesRequested);
    connect(edit_, &PlanCodeEdit::fixesRequested, this, &PlanTextPane::fixesRequested);
    connect(&lamp_timer_, &QTimer::timeout, this, &PlanTextPane::pausedAtFinding);
}

void PlanTextPane::showFinding(bool fits_robot) {
    QString words = edit_->wordsAtCursor();
    if (words.isEmpty())
        words = (fits_robot ? tr("Nothing is wrong with the plan; it fits the robot.")
                            : tr("Nothing is wrong with the plan.")) +
                (edit_->notes().empty() ? QString() : tr(" F8 goes to a note."));
    finding_->setText(words);
    fix_->hide();
    lamp_timer_.start();
}

void PlanTextPane::setFixable(bool fixable) {
    edit_->setLamp(fixable);
    fix_->setVisible(fixable);
}

void PlanTextPane::showFixes(const std::vector<posh::QuickFix>& fixes) {
    auto* const menu = new QMenu(edit_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const posh::QuickFix& fix : fixes)
        connect(menu->addAction(QString::fromStdString(fix.title)), &QAction::triggered, this,
                [this, edits = fix.edits, revision = edit_->document()->revision()] {
                    if (revision != edit_->document()->revision())
                        return;
                    edit_->applyEdits(edits);
                    emit fixed();
                    edit_->setFocus();
                });
    menu->setActiveAction(menu->actions().front());
    menu->popup(edit_->viewport()->mapToGlobal(edit_->cursorRect().bottomLeft()));
}

} // namespace usar::widgets
