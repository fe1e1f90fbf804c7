#include "core/campaign/comparison/svg_canvas.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::campaign {

namespace {

QString pixels(double value) {
    return QString::fromStdString(fixed(value, 1));
}

void writeAttributes(QXmlStreamWriter& xml, std::initializer_list<std::pair<const char*, QString>> attributes) {
    for (const auto& [name, value] : attributes)
        xml.writeAttribute(name, value);
}

} // namespace

SvgCanvas::SvgCanvas(QXmlStreamWriter& xml, double width, double height, const QString& style_class,
                     const QString& label)
    : xml_(xml) {
    xml_.writeStartElement("svg");
    writeAttributes(xml_, {{"class", style_class},
                           {"viewBox", QString("0 0 %1 %2").arg(width).arg(height)},
                           {"width", QString::number(width)},
                           {"height", QString::number(height)},
                           {"role", "img"},
                           {"aria-label", label}});
}

SvgCanvas::~SvgCanvas() {
    xml_.writeEndElement();
}

void SvgCanvas::line(QPointF from, QPointF to, const QString& style_class) {
    xml_.writeEmptyElement("line");
    writeAttributes(xml_, {{"class", style_class},
                           {"x1", pixels(from.x())},
                           {"y1", pixels(from.y())},
                           {"x2", pixels(to.x())},
                           {"y2", pixels(to.y())}});
}

void SvgCanvas::rectangle(QPointF top_left, QPointF bottom_right, const QString& style_class) {
    xml_.writeEmptyElement("rect");
    writeAttributes(xml_, {{"class", style_class},
                           {"x", pixels(top_left.x())},
                           {"y", pixels(top_left.y())},
                           {"width", pixels(bottom_right.x() - top_left.x())},
                           {"height", pixels(bottom_right.y() - top_left.y())}});
}

void SvgCanvas::circle(QPointF center, double radius, const QString& style_class) {
    xml_.writeEmptyElement("circle");
    writeAttributes(
        xml_, {{"class", style_class}, {"cx", pixels(center.x())}, {"cy", pixels(center.y())}, {"r", pixels(radius)}});
}

void SvgCanvas::text(QPointF at, const QString& anchor, const QString& words, const QString& style_class) {
    xml_.writeStartElement("text");
    writeAttributes(xml_,
                    {{"class", style_class}, {"x", pixels(at.x())}, {"y", pixels(at.y())}, {"text-anchor", anchor}});
    xml_.writeCharacters(words);
    xml_.writeEndElement();
}

void SvgCanvas::path(const std::vector<QPointF>& points, const QString& style_class) {
    QString steps;
    for (const QPointF& point : points)
        steps += (steps.isEmpty() ? "M" : "L") + pixels(point.x()) + ' ' + pixels(point.y());
    xml_.writeEmptyElement("path");
    writeAttributes(xml_, {{"class", style_class}, {"d", steps}});
}

void SvgCanvas::style(const QString& sheet) {
    xml_.writeDefaultNamespace("http://www.w3.org/2000/svg");
    xml_.writeTextElement("style", sheet);
    xml_.writeEmptyElement("rect");
    writeAttributes(xml_, {{"class", "paper"}, {"width", "100%"}, {"height", "100%"}});
}

std::vector<double> ticks(double low, double high, int count) {
    if (!(high > low))
        return {low};
    const double rough = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    const double step = power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
    std::vector<double> values;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
        values.push_back(i == 0.0 ? 0.0 : i * step);
    return values;
}

QString tickText(double value, const std::vector<double>& all) {
    const double step = all.size() > 1 ? all[1] - all[0] : std::max(std::abs(value), 1.0);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    const QString text = QString::fromStdString(fixed(std::abs(value), decimals));
    return value < 0.0 ? QChar(0x2212) + text : text;
}

} // namespace usar::campaign
