// Writes SVG elements; everything is escaped by the XML writer.
#pragma once

#include <vector>

#include <QPointF>
#include <QString>
#include <QXmlStreamWriter>

namespace usar::campaign {

/// An `<svg>` element from its construction to its destruction. Coordinates are CSS pixels from the top left corner.
/// The writer belongs to the caller and outlives it.
class SvgCanvas {
public:
    /// `label` is read aloud in place of the picture.
    SvgCanvas(QXmlStreamWriter& xml, double width, double height, const QString& style_class, const QString& label);
    ~SvgCanvas();
    SvgCanvas(const SvgCanvas&) = delete;
    SvgCanvas& operator=(const SvgCanvas&) = delete;

    void line(QPointF from, QPointF to, const QString& style_class);
    void rectangle(QPointF top_left, QPointF bottom_right, const QString& style_class);
    void circle(QPointF center, double radius, const QString& style_class);
    /// `anchor` is "start", "middle" or "end".
    void text(QPointF at, const QString& anchor, const QString& words, const QString& style_class = "axis");
    void path(const std::vector<QPointF>& points, const QString& style_class);
    /// Makes the picture one that stands in no page: with its name space, a style sheet and a background.
    void style(const QString& sheet);

private:
    QXmlStreamWriter& xml_;
};

/// Maps values onto pixels; `first` and `last` may be in either order.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double first = 0.0; ///< pixel of `low`
    double last = 1.0;  ///< pixel of `high`

    double operator()(double value) const { return first + (value - low) / (high - low) * (last - first); }
};

/// Round values for an axis, about `count` of them, within low to high; one step is 1, 2 or 5 times a power of ten.
std::vector<double> ticks(double low, double high, int count);

/// With as many decimals as the step between ticks needs.
QString tickText(double value, const std::vector<double>& all);

} // namespace usar::campaign
