#include "widgets/plan/editor/plan_editor_head.h"

#include <utility>

#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

PlanEditorHead::PlanEditorHead(const PlanActions& actions, const PlanEditorPanes& panes, const PlanEditorMenus& menus,
                               QWidget* parent)
    : QWidget(parent) {
    rows_ = laidOut(new QBoxLayout(QBoxLayout::LeftToRight, this), {}, gap::tiny);
    auto* files = laidOut(new QHBoxLayout, gap::tiny);
    addMenuButton(files, tr("New plan"), QStringLiteral("page"), menus.new_plan);
    addButton(files, actions.action("open"));
    addButton(files, actions.action("save"));
    addMenuButton(files, tr("Save as, other dialects, pictures"), QStringLiteral("export"), menus.save_as);
    addButton(files, actions.action("undo"));
    addButton(files, actions.action("redo"));
    addMenuButton(files, tr("Compare"), QStringLiteral("compare"), menus.compare);
    title_ = new QLabel(this);
    title_->setProperty("role", "title");
    title_->setMinimumWidth(40);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    files->addWidget(title_, 1);
    rows_->addLayout(files, 1);
    auto* shown = laidOut(new QHBoxLayout, gap::tiny);
    palette_shown_ = addToggle(shown, tr("Shows the pieces that a plan can be made of"), "pieces", panes.palette);
    text_shown_ = addToggle(shown, tr("Shows the text"), "text", panes.text);
    drawing_shown_ = addToggle(shown, tr("Shows the drawing"), "branches", panes.drawing);
    lists_shown_ = addToggle(shown, tr("Shows findings, differences and usages"), "warning", panes.lists);
    shown->addStretch(1);
    apply_action_ = actions.action("apply");
    apply_ = new QPushButton(apply_action_->text(), this);
    apply_->setProperty("role", "primary");
    connect(apply_, &QPushButton::clicked, apply_action_, &QAction::trigger);
    shown->addWidget(apply_);
    rows_->addLayout(shown);
}

void PlanEditorHead::addButton(QBoxLayout* row, QAction* action) {
    QToolButton* const button = makeToolButton(action->toolTip(), this);
    showAction(button, action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    row->addWidget(button);
}

void PlanEditorHead::addMenuButton(QBoxLayout* row, const QString& help, const QString& icon_name, QMenu* menu) {
    QToolButton* const button = makeToolButton(help, this, icon_name);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    row->addWidget(button);
}

QToolButton* PlanEditorHead::addToggle(QBoxLayout* row, const QString& help, const char* icon_name, QWidget* what) {
    QToolButton* const button = makeToolButton(help, this, QString::fromLatin1(icon_name));
    button->setCheckable(true);
    connect(button, &QToolButton::toggled, what, &QWidget::setVisible);
    button->setChecked(true);
    row->addWidget(button);
    return button;
}

bool PlanEditorHead::setTitle(const QString& title, const QString& help) {
    if (title == title_->text())
        return false;
    title_->setText(title);
    title_->setToolTip(help);
    return true;
}

void PlanEditorHead::setApplicable(bool applicable, const QString& why_not) {
    applicable_ = applicable;
    why_not_applicable_ = why_not;
    showApply();
}

void PlanEditorHead::setRunnable(bool runnable) {
    runnable_ = runnable;
    showApply();
}

void PlanEditorHead::showApply() {
    apply_action_->setEnabled(applicable_ && runnable_);
    apply_->setEnabled(apply_action_->isEnabled());
    apply_->setToolTip(!applicable_ ? why_not_applicable_
                       : !runnable_ ? tr("The plan has errors; fix them first")
                                    : apply_action_->toolTip());
    apply_->setVisible(applicable_ || !why_not_applicable_.isEmpty());
}

PlanOfferBar::PlanOfferBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    words_ = makeLabel(this);
    accept_ = makeToolButton(tr("Accept"), this);
    accept_->setAutoRaise(false);
    connect(accept_, &QToolButton::clicked, this, [this] {
        hide();
        if (const auto run = std::exchange(run_, nullptr))
            run();
    });
    auto* no = makeToolButton(tr("Dismiss"), this, QStringLiteral("clear"));
    connect(no, &QToolButton::clicked, this, &QWidget::hide);
    laidOut(new QHBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::tiny}, -1, {words_, accept_, no})
        ->setStretchFactor(words_, 1);
    hide();
}

void PlanOfferBar::offer(const QString& words, const QString& accept, std::function<void()> run) {
    words_->setText(words);
    accept_->setText(accept);
    accept_->setAccessibleName(accept);
    run_ = std::move(run);
    show();
}

} // namespace usar::widgets
