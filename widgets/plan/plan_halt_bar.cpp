#include "widgets/plan/plan_halt_bar.h"

#include <QAction>
#include <QEvent>

#include "widgets/plan/plan_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int narrow_px = 560;
constexpr int halt_icon_px = 18;

} // namespace

PlanHaltBar::PlanHaltBar(QWidget* parent)
    : QFrame(parent)
    , column_(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , icon_(new QLabel(this))
    , text_(makeLabel(this, "title"))
    , buttons_(new QBoxLayout(QBoxLayout::LeftToRight)) {
    setProperty("role", "card");
    setAccessibleName(tr("The plan is halted"));
    column_->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    column_->setSpacing(gap::small);
    auto* words = new QHBoxLayout;
    words->setSpacing(gap::small);
    words->addWidget(icon_, 0, Qt::AlignTop);
    words->addWidget(text_, 1);
    buttons_->setSpacing(gap::tiny);
    column_->addLayout(words, 1);
    column_->addLayout(buttons_);
    showIcon();
    hide();
}

void PlanHaltBar::setActions(const QList<QAction*>& actions) {
    for (QAction* action : actions) {
        QToolButton* const button = makeToolButton(action->text(), this);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(false);
        buttons_->addWidget(button);
    }
}

void PlanHaltBar::setText(const QString& text) {
    text_->setText(text);
    setAccessibleDescription(text);
    setVisible(!text.isEmpty());
}

void PlanHaltBar::resizeEvent(QResizeEvent* event) {
    column_->setDirection(width() < narrow_px ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    QFrame::resizeEvent(event);
}

void PlanHaltBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        showIcon();
    QFrame::changeEvent(event);
}

void PlanHaltBar::showIcon() {
    icon_->setPixmap(icon(QStringLiteral("pause"), tokens().caution).pixmap(halt_icon_px, halt_icon_px));
}

} // namespace usar::widgets
