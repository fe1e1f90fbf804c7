#include "core/mission/files/picture_legend.h"

#include <algorithm>
#include <cmath>

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLinearGradient>
#include <QPainter>
#include <QPolygonF>

namespace usar::mission {

namespace {

/// "Low risk": the same words as in the window.
QString labelOf(agent::MarkKind kind) {
    return QString::fromUtf8(agent::styleOf(kind).name);
}

using agent::MarkKind;

const QColor strip_color(24, 28, 36);
const QColor ink_color(232, 235, 240);
const QColor rim_color(0, 0, 0, 170);

bool hasLetters() {
    return qobject_cast<QGuiApplication*>(QCoreApplication::instance()) != nullptr;
}

QFont legendFont(double text_px) {
    QFont font("DejaVu Sans");
    font.setPixelSize(static_cast<int>(std::lround(text_px)));
    return font;
}

double textWidth(const QString& text, double text_px) {
    return hasLetters() ? QFontMetricsF(legendFont(text_px)).horizontalAdvance(text)
                        : 0.6 * text_px * double(text.size());
}

void drawText(QPainter& painter, const QPointF& baseline, const QString& text) {
    if (hasLetters())
        painter.drawText(baseline, text);
}

/// Calls `place` with each kind of mark, the left end of its entry in pixels, and its line; returns the number of
/// lines.
template <class Place>
int flowMarks(double width_px, double text_px, const Place& place) {
    double x = text_px;
    int line = 0;
    for (const MarkKind kind : agent::all_mark_kinds) {
        const double entry_px = textWidth(labelOf(kind), text_px) + 3.0 * text_px;
        if (x + entry_px > width_px && x > text_px) {
            x = text_px;
            ++line;
        }
        place(kind, x, line);
        x += entry_px;
    }
    return line + 1;
}

/// Formats a length in meters without trailing zeros.
QString meters(double length_m) {
    return QString::number(length_m, 'g', 6) + " m";
}

QString height(float height_m) {
    return QString::number(double(height_m), 'f', 2) + " m";
}

void drawRange(QPainter& painter, const mapping::HeightRange& range, mapping::ColorMap colors, double text_px,
               double top_px) {
    const QRectF bar(text_px + textWidth(height(range.minimum_m), text_px) + 0.5 * text_px, top_px, 8.0 * text_px,
                     text_px);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr float steps = 32.0f;
    for (float step = 0.0f; step <= steps; ++step)
        gradient.setColorAt(static_cast<double>(step / steps),
                            QColor::fromRgb(mapping::shade(step, {0.0f, steps}, colors)));
    painter.setPen(QPen(ink_color, std::max(1.0, text_px / 14.0)));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    const double baseline_px = top_px + 0.85 * text_px;
    drawText(painter, {text_px, baseline_px}, height(range.minimum_m));
    drawText(painter, {bar.right() + 0.5 * text_px, baseline_px}, height(range.maximum_m));
}

void drawScaleBar(QPainter& painter, double pixels_per_m, double text_px, const QPointF& right_end, double room_px) {
    const double length_m = scaleBarLength_m(pixels_per_m, room_px);
    const double length_px = length_m * pixels_per_m;
    const double left_px = right_end.x() - length_px;
    painter.setPen(QPen(ink_color, std::max(1.5, text_px / 8.0), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(left_px, right_end.y()), right_end);
    for (const double x : {left_px, right_end.x()})
        painter.drawLine(QPointF(x, right_end.y() - 0.35 * text_px), QPointF(x, right_end.y() + 0.35 * text_px));
    const QString label = meters(length_m);
    drawText(painter, {left_px - textWidth(label, text_px) - 0.6 * text_px, right_end.y() + 0.35 * text_px}, label);
}

} // namespace

void drawMark(QPainter& painter, MarkKind kind, const QPointF& center, double unit_px) {
    const agent::MarkStyle& style = agent::styleOf(kind);
    const QColor color(style.rgb);
    painter.setPen(QPen(rim_color, std::max(1.0, unit_px * 0.4)));
    painter.setBrush(color);
    if (style.shape == agent::MarkShape::Square) {
        painter.drawRect(QRectF(center.x() - 1.7 * unit_px, center.y() - 1.7 * unit_px, 3.4 * unit_px, 3.4 * unit_px));
    } else if (style.shape == agent::MarkShape::Ring) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(rim_color, unit_px * 1.7));
        painter.drawEllipse(center, 2.6 * unit_px, 2.6 * unit_px);
        painter.setPen(QPen(color, unit_px));
        painter.drawEllipse(center, 2.6 * unit_px, 2.6 * unit_px);
    } else if (style.shape == agent::MarkShape::Cross) {
        const QPointF slash(1.6 * unit_px, 1.6 * unit_px), back(1.6 * unit_px, -1.6 * unit_px);
        for (const QPen& pen : {QPen(rim_color, unit_px * 1.6), QPen(color, unit_px * 0.8)}) {
            painter.setPen(pen);
            painter.drawLine(center - slash, center + slash);
            painter.drawLine(center - back, center + back);
        }
    } else if (style.shape == agent::MarkShape::Triangle || style.shape == agent::MarkShape::Diamond) {
        const double r = 1.8 * unit_px;
        painter.drawPolygon(
            style.shape == agent::MarkShape::Triangle
                ? QPolygonF({center + QPointF(0.0, -r), center + QPointF(r, 0.8 * r), center + QPointF(-r, 0.8 * r)})
                : QPolygonF({center + QPointF(0.0, -r), center + QPointF(r, 0.0), center + QPointF(0.0, r),
                             center + QPointF(-r, 0.0)}));
    } else if (style.shape == agent::MarkShape::Dot) {
        painter.setPen(Qt::NoPen); // Path dots are close together: their rims would form a black line.
        painter.drawEllipse(center, unit_px, unit_px);
    } else {
        painter.drawEllipse(center, 1.4 * unit_px, 1.4 * unit_px);
    }
}

double scaleBarLength_m(double pixels_per_m, double room_px) {
    const double room_m = room_px / pixels_per_m;
    const double power = std::pow(10.0, std::floor(std::log10(room_m)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= room_m)
            return factor * power;
    }
    return power;
}

int Legend::heightFor(int width_px) const {
    const int mark_lines = flowMarks(width_px, text_px, [](MarkKind, double, int) {});
    return static_cast<int>(std::ceil((4.4 + 1.7 * mark_lines) * text_px));
}

void Legend::draw(QPainter& painter, const QRect& strip) const {
    painter.save();
    painter.fillRect(strip, strip_color);
    painter.translate(strip.topLeft());
    painter.setFont(legendFont(text_px));
    painter.setPen(ink_color);
    drawText(painter, {text_px, 1.5 * text_px}, title);
    if (range)
        drawRange(painter, *range, colors, text_px, 2.3 * text_px);
    drawScaleBar(painter, pixels_per_m, text_px, {strip.width() - text_px, 2.8 * text_px}, strip.width() * 0.25);
    flowMarks(strip.width(), text_px, [&](MarkKind kind, double x, int line) {
        const double middle_px = (4.9 + 1.7 * line) * text_px;
        drawMark(painter, kind, {x + 0.6 * text_px, middle_px}, text_px * 0.19);
        painter.setPen(ink_color);
        drawText(painter, {x + 1.6 * text_px, middle_px + 0.35 * text_px}, labelOf(kind));
    });
    painter.restore();
}

} // namespace usar::mission
