#include "widgets/bars/tour_card.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QKeyEvent>
#include <QPainter>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int card_width_px = 320;

int clamped(int value, int low, int high) {
    return std::max(low, std::min(value, high));
}

} // namespace

TourRing::TourRing(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void TourRing::surround(const QRect& part) {
    if (part.isEmpty())
        return hide();
    // At the edge of the window the ring covers a little of the part; otherwise a side of it would be missing.
    setGeometry(part.adjusted(-thickness_px, -thickness_px, thickness_px, thickness_px) & parentWidget()->rect());
    show();
    raise();
}

void TourRing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(tokens().accent, thickness_px));
    const double half = thickness_px / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), 4.0, 4.0);
}

TourCard::TourCard(QWidget* window) : QFrame(window) {
    setProperty("role", "card");
    number_->setProperty("role", "muted");
    number_->setFont(themeFont(FontRole::Small));
    title_->setProperty("role", "title");
    tick_->setProperty("role", "ok");
    for (QLabel* const label : {text_, title_})
        label->setWordWrap(true);
    leave_->setToolTip(tr("Ends the tour (Escape); Tour in the Help menu begins it again"));
    next_->setProperty("role", "primary");
    auto* const column = laidOut(new QVBoxLayout(this), {gap::medium, gap::medium, gap::medium, gap::medium},
                                 gap::small, {number_, title_, text_});
    auto* const row = laidOut(new QHBoxLayout, gap::small, {tick_, leave_, next_});
    row->setStretchFactor(tick_, 1);
    column->addLayout(row);
    for (QPushButton* const button : {leave_, next_})
        button->setMinimumHeight(minimum_target);
    connect(leave_, &QPushButton::clicked, this, &TourCard::leaveRequested);
    connect(next_, &QPushButton::clicked, this, &TourCard::nextRequested);
    hide();
}

void TourCard::showStep(int number, int count, const QString& title, const QString& text) {
    const bool last = number == count;
    number_->setText(tr("Step %1 of %2").arg(number).arg(count));
    title_->setText(title);
    text_->setText(text);
    setAccessibleName(tr("Tour, step %1 of %2: %3").arg(number).arg(count).arg(title));
    setAccessibleDescription(text);
    next_->setText(last ? tr("Finish") : tr("Next"));
    next_->setToolTip(last ? tr("Ends the tour") : tr("Goes on to the next step, whether this one was done or not"));
    leave_->setVisible(!last);
    setDone(false);
    show();
    raise();
}

void TourCard::setDone(bool done) {
    tick_->setText(done ? tr("✓ Done") : QString());
}

void TourCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter)
        return QFrame::keyPressEvent(event);
    (leave_->hasFocus() ? leave_ : next_)->click();
}

void TourCard::standBeside(const QRect& ring, bool rather_below) {
    const QSize size(card_width_px, layout()->totalHeightForWidth(card_width_px));
    setGeometry(placeBeside(
        ring, size, parentWidget()->rect().adjusted(gap::small, gap::small, -gap::small, -gap::small), rather_below));
}

QRect placeBeside(const QRect& ring, const QSize& card, const QRect& room, bool rather_below) {
    const int x = clamped(ring.left(), room.left(), room.right() + 1 - card.width());
    const int y = clamped(ring.top(), room.top(), room.bottom() + 1 - card.height());
    std::array<QPoint, 4> corners{QPoint(ring.right() + 1 + gap::medium, y), QPoint(x, ring.bottom() + 1 + gap::medium),
                                  QPoint(ring.left() - gap::medium - card.width(), y),
                                  QPoint(x, ring.top() - gap::medium - card.height())};
    if (rather_below)
        std::swap(corners[0], corners[1]);
    for (const QPoint& corner : corners)
        if (room.contains(QRect(corner, card)))
            return {corner, card};
    const QPoint within = ring.bottomRight() - QPoint(card.width() + gap::large, card.height() + gap::large);
    return {QPoint(clamped(within.x(), room.left(), room.right() + 1 - card.width()),
                   clamped(within.y(), room.top(), room.bottom() + 1 - card.height())),
            card};
}

} // namespace usar::widgets
