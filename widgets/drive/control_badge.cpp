#include "widgets/drive/control_badge.h"

#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int badge_height_px = 26;
constexpr int usual_width_px = 168; // "R1: you drive · keys"
constexpr int roomy_width_px = 264; // "R1: Terrain survey (C++) drives"
constexpr int least_width_px = 136; // "R1: you drive"

StateShape shapeOf(Driver driver) {
    return driver == Driver::Person     ? StateShape::Busy
           : driver == Driver::Behavior ? StateShape::Good
                                        : StateShape::Off;
}

} // namespace

ControlBadge::ControlBadge(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    dot_->setAttribute(Qt::WA_TransparentForMouseEvents);
    dot_->setGeometry(gap::small, (badge_height_px - 16) / 2, 16, 16);
    setWords({});
}

void ControlBadge::setWords(const ControlWords& words) {
    if (words == words_ && !accessibleName().isEmpty())
        return;
    words_ = words;
    dot_->setState(shapeOf(words.driver));
    setAccessibleName(text());
    setToolTip(tr("Who drives: %1. Click to open the dock Drive.").arg(text()));
    update();
}

QString ControlBadge::text() const {
    if (words_.robot.isEmpty())
        return tr("No robot");
    return bare_ ? controlText(words_) : tr("%1: %2").arg(words_.robot, controlText(words_));
}

void ControlBadge::setBare(bool bare) {
    bare_ = bare;
    setSizePolicy(bare ? QSizePolicy::Expanding : QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(text());
    update();
}

void ControlBadge::setRoomy(bool roomy) {
    if (std::exchange(roomy_, roomy) != roomy)
        updateGeometry();
}

QSize ControlBadge::sizeHint() const {
    return {roomy_ ? roomy_width_px : usual_width_px, badge_height_px};
}

QSize ControlBadge::minimumSizeHint() const {
    return {least_width_px, badge_height_px};
}

void ControlBadge::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool person = words_.driver == Driver::Person;
    painter.setPen(QPen(hasFocus() || person ? t.accent : t.line, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(t.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 12.0, 12.0);
    painter.setPen(words_.driver == Driver::Nobody ? t.text_muted : t.text);
    painter.setFont(themeFont(FontRole::Body, person ? QFont::DemiBold : QFont::Normal));
    const QRect line = rect().adjusted(gap::small + 16 + gap::tiny, 0, -gap::small, 0);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, fittedText(text(), painter.fontMetrics(), line.width()));
}

void ControlBadge::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        emit clicked();
}

void ControlBadge::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        return emit clicked();
    QWidget::keyPressEvent(event);
}

} // namespace usar::widgets
