#include "widgets/messages/toast.h"

#include <QGridLayout>
#include <QMouseEvent>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

Toast::Toast(const Notification& notification, int lifetime_ms, QWidget* parent)
    : QFrame(parent)
    , key_(notification.key) {
    setProperty("role", "card");
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Click to see all notifications"));
    word_->setFont(themeFont(FontRole::Small));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    auto* close = new QToolButton(this);
    close->setIcon(icon(QStringLiteral("clear")));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::NoFocus);
    close->setCursor(Qt::ArrowCursor);
    close->setFixedSize(minimum_target, minimum_target);
    named(close, tr("Close this message"), tr("Close this message"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap::small, gap::tiny, gap::tiny, gap::small);
    grid->setHorizontalSpacing(gap::small);
    grid->setVerticalSpacing(0);
    grid->addWidget(sign_, 0, 0);
    grid->addWidget(word_, 0, 1);
    grid->addWidget(close, 0, 2);
    grid->addWidget(text_, 1, 1, 1, 2);
    offer_->setFocusPolicy(Qt::NoFocus);
    offer_->setCursor(Qt::ArrowCursor);
    offer_->setMinimumHeight(minimum_target);
    grid->addWidget(offer_, 2, 1, 1, 2, Qt::AlignRight);
    grid->setColumnStretch(1, 1);
    life_.setSingleShot(true);
    life_.setInterval(lifetime_ms);
    connect(&life_, &QTimer::timeout, this, &Toast::finished);
    connect(close, &QToolButton::clicked, this, &Toast::finished);
    connect(offer_, &QPushButton::clicked, this, &Toast::offerTaken);
    show(notification);
    onThemeChange(this, [this] { paintSign(); });
}

void Toast::show(const Notification& notification) {
    severity_ = notification.severity;
    const QString word = severityWord(severity_);
    word_->setText(notification.count > 1 ? word + QStringLiteral("  ×%1").arg(notification.count) : word);
    text_->setText(notification.text);
    setAccessibleName(word + QStringLiteral(": ") + notification.text);
    offer_->setText(notification.offer.text);
    offer_->setToolTip(notification.offer.help);
    offer_->setAccessibleDescription(notification.offer.help);
    offer_->setVisible(notification.offers());
    paintSign();
    startLife();
    QWidget::show();
}

void Toast::startLife() {
    life_.stop();
    if (offer_->isHidden())
        life_.start();
}

void Toast::paintSign() {
    sign_->setPixmap(icon(severityIcon(severity_), severityColor(severity_)).pixmap(16, 16));
    QPalette ink = word_->palette();
    ink.setColor(QPalette::WindowText, severityColor(severity_));
    word_->setPalette(ink);
}

void Toast::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        emit clicked();
}

void Toast::enterEvent(QEnterEvent* event) {
    life_.stop();
    QFrame::enterEvent(event);
}

void Toast::leaveEvent(QEvent* event) {
    startLife();
    QFrame::leaveEvent(event);
}

} // namespace usar::widgets
