#include "widgets/panels/attitude_view.h"

#include <algorithm>
#include <cmath>

#include <QPainterPath>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr double shown_rad = radians(45.0); ///< pitch at the rim of the horizon

/// "3° right": the size of an angle with the word for its sign.
QString leaning(double angle_rad, const QString& positive, const QString& negative) {
    const QString size = figure(std::abs(degrees(angle_rad)), 0);
    return size == QStringLiteral("0") ? AttitudeView::tr("level")
                                       : QStringLiteral("%1° %2").arg(size, angle_rad > 0.0 ? positive : negative);
}

QPointF onCircle(const QPointF& center, double radius, double clockwise_from_top_rad) {
    return center + radius * QPointF(std::sin(clockwise_from_top_rad), -std::cos(clockwise_from_top_rad));
}

} // namespace

AttitudeView::AttitudeView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Attitude and heading"));
}

QSize AttitudeView::minimumSizeHint() const {
    const int line = QFontMetrics(themeFont(FontRole::Small)).height();
    return {200, static_cast<int>(sheetHead_px(*this)) + 88 + 2 * line + gap::small};
}

QString AttitudeView::rollText(double roll_rad) {
    return leaning(roll_rad, tr("right"), tr("left"));
}

QString AttitudeView::pitchText(double pitch_rad) {
    return leaning(-pitch_rad, tr("up"), tr("down"));
}

QString AttitudeView::yawText(double yaw_rad) {
    return tr("yaw %1°").arg(figure(degrees(normalizedAngle(yaw_rad)), 0));
}

void AttitudeView::setAttitude(const Vec3& roll_pitch_yaw_rad, const QString& source) {
    if (source == source_ && roll_pitch_yaw_rad == roll_pitch_yaw_rad_)
        return;
    if (source != source_)
        setToolTip(tr("Left: how the robot leans, with marks for the roll at 10, 20, 30 and 60 degrees, and for the "
                      "pitch every 10 degrees. Right: where it heads, as on the map; yaw from −180 to 180 degrees, "
                      "counterclockwise from the map's x axis. Told by %1.")
                       .arg(source));
    roll_pitch_yaw_rad_ = roll_pitch_yaw_rad;
    source_ = source;
    showFresh(tr("roll %1, pitch %2, %3, by %4")
                  .arg(rollText(roll_pitch_yaw_rad.x()), pitchText(roll_pitch_yaw_rad.y()),
                       yawText(roll_pitch_yaw_rad.z()), source));
}

void AttitudeView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (source_.isEmpty())
        return paintEmptySheet(painter, *this, tr("No attitude yet."));
    paintSheet(painter, *this);
    paintHead(painter, tr("attitude"), source_);
    painter.setFont(themeFont(FontRole::Small));
    const double line = QFontMetricsF(painter.font()).height();
    const double top = sheetHead_px(*this) + gap::tiny;
    const double room = height() - top - 2.0 * line - gap::tiny;
    const double radius = std::max(10.0, std::min(room, width() / 2.0 - 2.0 * gap::small) / 2.0 - 1.0);
    const QPointF left(width() * 0.25, top + room / 2.0);
    const QPointF right(width() * 0.75, top + room / 2.0);
    paintHorizon(painter, left, radius);
    paintCompass(painter, right, radius);
    painter.setPen(ink(tokens().text));
    QFont font = themeFont(FontRole::Small);
    font.setStrikeOut(stale());
    painter.setFont(font);
    const auto words = [&](double x, int row, const QString& text) {
        painter.drawText(QRectF(x, top + room + row * line, width() / 2.0, line), Qt::AlignCenter, text);
    };
    words(0.0, 0, tr("roll %1").arg(rollText(roll_pitch_yaw_rad_.x())));
    words(0.0, 1, tr("pitch %1").arg(pitchText(roll_pitch_yaw_rad_.y())));
    words(width() / 2.0, 0, yawText(roll_pitch_yaw_rad_.z()));
}

void AttitudeView::paintHorizon(QPainter& painter, const QPointF& center, double radius) const {
    const Tokens& t = tokens();
    const double pixels_per_rad = radius / shown_rad;
    const double roll_rad = roll_pitch_yaw_rad_.x();
    const double shift = std::clamp(-roll_pitch_yaw_rad_.y() * pixels_per_rad, -0.85 * radius, 0.85 * radius);
    QPainterPath disc;
    disc.addEllipse(center, radius, radius);
    painter.save();
    painter.setClipPath(disc);
    painter.translate(center);
    painter.rotate(-degrees(roll_rad)); // The world turns against the robot.
    const double far = 3.0 * radius;
    painter.fillRect(QRectF(-far, -far, 2.0 * far, far + shift), faded(ink(t.accent), stale() ? 0.10 : 0.30));
    painter.fillRect(QRectF(-far, shift, 2.0 * far, far), faded(ink(t.caution), stale() ? 0.22 : 0.38));
    painter.setPen(QPen(ink(t.text), 1.5));
    painter.drawLine(QPointF(-far, shift), QPointF(far, shift));
    painter.translate(0.0, -roll_pitch_yaw_rad_.y() * pixels_per_rad);
    paintLadder(painter, radius, pixels_per_rad);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.line, 1.0));
    painter.drawEllipse(center, radius, radius);
    paintRollScale(painter, center, radius);
    paintWings(painter, center, radius);
}

void AttitudeView::paintLadder(QPainter& painter, double radius, double pixels_per_rad) const {
    painter.setFont(themeFont(FontRole::Small));
    painter.setPen(QPen(faded(ink(tokens().text), 0.7), 1.0));
    for (int step = -8; step <= 8; ++step) {
        if (step == 0)
            continue;
        const double y = -radians(10.0 * step) * pixels_per_rad;
        const double half = (step % 2 == 0 ? 0.30 : 0.18) * radius;
        painter.drawLine(QPointF(-half, y), QPointF(half, y));
    }
}

void AttitudeView::paintRollScale(QPainter& painter, const QPointF& center, double radius) const {
    painter.setPen(QPen(ink(tokens().text), 1.0));
    for (const double mark_deg : {-60.0, -30.0, -20.0, -10.0, 0.0, 10.0, 20.0, 30.0, 60.0})
        painter.drawLine(onCircle(center, radius, radians(mark_deg)),
                         onCircle(center, radius * (mark_deg == 0.0 ? 0.88 : 0.93), radians(mark_deg)));
    const double roll_rad = -roll_pitch_yaw_rad_.x(); // The pointer is fixed to the sky.
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink(tokens().text));
    painter.drawPolygon(QPolygonF{onCircle(center, radius * 0.92, roll_rad),
                                  onCircle(center, radius * 0.80, roll_rad - 0.07),
                                  onCircle(center, radius * 0.80, roll_rad + 0.07)});
}

void AttitudeView::paintWings(QPainter& painter, const QPointF& center, double radius) const {
    QPainterPath wings;
    for (const double side : {-1.0, 1.0}) {
        wings.moveTo(center + QPointF(side * 0.55 * radius, 0.0));
        wings.lineTo(center + QPointF(side * 0.2 * radius, 0.0));
        wings.lineTo(center + QPointF(side * 0.1 * radius, 0.1 * radius));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens().surface, 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)); // It lies over lines.
    painter.drawPath(wings);
    painter.setPen(QPen(ink(tokens().text), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(wings);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink(tokens().text));
    painter.drawEllipse(center, 2.0, 2.0);
}

void AttitudeView::paintCompass(QPainter& painter, const QPointF& center, double radius) const {
    const Tokens& t = tokens();
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(t.raised);
    painter.drawEllipse(center, radius, radius);
    painter.setPen(QPen(t.text_muted, 1.0));
    for (int mark = 0; mark < 12; ++mark)
        painter.drawLine(onCircle(center, radius, mark * pi / 6.0),
                         onCircle(center, radius * (mark % 3 == 0 ? 0.86 : 0.93), mark * pi / 6.0));
    painter.setFont(themeFont(FontRole::Small));
    const auto label = [&](double clockwise_from_top_rad, const QString& text) {
        const QPointF at = onCircle(center, radius * 0.72, clockwise_from_top_rad);
        painter.drawText(QRectF(at - QPointF(20.0, 10.0), QSizeF(40.0, 20.0)), Qt::AlignCenter, text);
    };
    label(pi / 2.0, QStringLiteral("x"));
    label(0.0, QStringLiteral("y"));
    label(-pi / 2.0, QStringLiteral("−x"));
    label(pi, QStringLiteral("−y"));
    const double heading_rad = pi / 2.0 - roll_pitch_yaw_rad_.z();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink(t.text));
    painter.drawPolygon(QPolygonF{
        onCircle(center, radius * 0.58, heading_rad), onCircle(center, radius * 0.42, heading_rad + 2.5),
        onCircle(center, radius * 0.18, heading_rad + pi), onCircle(center, radius * 0.42, heading_rad - 2.5)});
}

} // namespace usar::widgets
