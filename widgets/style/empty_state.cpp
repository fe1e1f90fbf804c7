#include "widgets/style/empty_state.h"

#include <QEvent>
#include <QVBoxLayout>

#include "widgets/style/theme.h"

namespace usar::widgets {

EmptyState::EmptyState(QWidget* covered) : QWidget(covered) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap::medium, gap::medium, gap::medium, gap::medium);
    column->setSpacing(gap::small);
    column->addStretch();
    column->addWidget(title_);
    column->addWidget(hint_);
    column->addWidget(button_, 0, Qt::AlignHCenter);
    column->addStretch();
    setObjectName(QStringLiteral("emptyState"));
    title_->setAlignment(Qt::AlignCenter);
    title_->setProperty("role", "title");
    title_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setProperty("role", "muted");
    hint_->setWordWrap(true);
    // Labels and the sheet itself are transparent for the mouse: only the button takes clicks.
    title_->setAttribute(Qt::WA_TransparentForMouseEvents);
    hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
    button_->setProperty("role", "primary");
    button_->hide();
    covered->installEventFilter(this);
    setGeometry(covered->rect());
}

void EmptyState::setText(const QString& title, const QString& hint) {
    title_->setText(title);
    hint_->setText(hint);
    setAccessibleName(title);
    setAccessibleDescription(hint);
}

void EmptyState::setAction(QAction* action) {
    disconnect(clicked_); // Only this connection: the style also connects to every widget.
    button_->setVisible(action != nullptr);
    if (!action)
        return;
    button_->setText(action->text());
    button_->setToolTip(action->toolTip());
    clicked_ = connect(button_, &QPushButton::clicked, action, &QAction::trigger);
}

bool EmptyState::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == parent())
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace usar::widgets
