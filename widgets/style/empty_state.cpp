#include "widgets/style/empty_state.h"

#include "widgets/style/theme.h"

namespace usar::widgets {

EmptyState::EmptyState(QWidget* covered, const QString& title, const QString& hint) : QWidget(covered) {
    auto* column = laidOut(new QVBoxLayout(this), {gap::medium, gap::tiny, gap::medium, gap::tiny}, gap::small);
    column->addStretch();
    column->addWidget(title_);
    column->addWidget(hint_);
    column->addWidget(button_, 0, Qt::AlignHCenter);
    column->addStretch();
    setObjectName(QStringLiteral("emptyState"));
    title_->setProperty("role", "title");
    for (QLabel* label : {title_, hint_}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
        label->setAttribute(Qt::WA_TransparentForMouseEvents); // Only the button takes clicks.
    }
    button_->hide();
    covered->installEventFilter(this);
    setGeometry(covered->rect());
    setText(title, hint);
}

void EmptyState::setText(const QString& title, const QString& hint) {
    title_->setText(title);
    hint_->setText(hint);
    setAccessibleName(title);
    setAccessibleDescription(hint);
    fit();
}

void EmptyState::setAction(QAction* action, const char* role) {
    disconnect(clicked_); // Only this connection: the style also connects to every widget.
    has_action_ = action != nullptr;
    button_->setVisible(has_action_ && action_helps_);
    if (!action)
        return fit();
    setRole(button_, role);
    button_->setText(action->text());
    button_->setToolTip(action->toolTip());
    clicked_ = connect(button_, &QPushButton::clicked, action, &QAction::trigger);
    fit();
}

void EmptyState::offerAction(bool helps) {
    action_helps_ = helps;
    button_->setVisible(has_action_ && action_helps_);
    fit();
}

void EmptyState::fit() {
    const int width_px = width() - 2 * gap::medium;
    int needed_px = 2 * gap::tiny + title_->heightForWidth(width_px) + gap::small + hint_->heightForWidth(width_px);
    if (!button_->isHidden())
        needed_px += gap::small + button_->sizeHint().height();
    hint_->setHidden(needed_px > height());
    setToolTip(hint_->isHidden() ? hint_->text() : QString());
}

void EmptyState::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

bool EmptyState::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == parent())
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace usar::widgets
