#include "widgets/style/svg_paint.h"

#include <algorithm>
#include <cmath>

#include <QFontInfo>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPen>

namespace usar::widgets {

namespace {

constexpr int dots_per_inch = 96;

QString number(double value) {
    const QString text = QString::number(value, 'f', 2);
    return text.endsWith(QLatin1String(".00")) ? text.chopped(3) : text;
}

QString pair(double x, double y) {
    return number(x) + u' ' + number(y);
}

/// Returns an attribute such as ` fill="#rrggbb"`, with the opacity unless it is 1.
QString colorOf(const char* what, const QColor& color) {
    QString text = QStringLiteral(" %1=\"%2\"").arg(QLatin1String(what), color.name());
    if (color.alpha() < 255)
        text += QStringLiteral(" %1-opacity=\"%2\"").arg(QLatin1String(what), number(color.alphaF()));
    return text;
}

QString pathData(const QPainterPath& path) {
    QString data;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element at = path.elementAt(i);
        if (at.isMoveTo())
            data += u'M';
        else if (at.isLineTo())
            data += u'L';
        else if (at.type == QPainterPath::CurveToElement)
            data += u'C';
        else
            data += u' '; // Continues a curve.
        data += pair(at.x, at.y);
    }
    return data;
}

} // namespace

class SvgPaintEngine : public QPaintEngine {
public:
    SvgPaintEngine() : QPaintEngine(QPaintEngine::AllFeatures) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return QPaintEngine::User; }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}

    void updateState(const QPaintEngineState& now) override {
        if (now.state() & DirtyPen)
            pen_ = now.pen();
        if (now.state() & DirtyBrush)
            brush_ = now.brush();
        if (now.state() & DirtyTransform)
            transform_ = now.transform();
    }

    void drawPath(const QPainterPath& path) override {
        body_ += QStringLiteral("<path d=\"%1\"%2%3/>\n").arg(pathData(transform_.map(path)), fill(true), stroke());
    }

    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        QPainterPath path;
        for (int i = 0; i < count; ++i)
            i == 0 ? path.moveTo(points[i]) : path.lineTo(points[i]);
        if (mode != PolylineMode)
            path.closeSubpath();
        body_ += QStringLiteral("<path d=\"%1\"%2%3/>\n")
                     .arg(pathData(transform_.map(path)), fill(mode != PolylineMode), stroke());
    }

    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QFont font = item.font();
        const QPointF place = transform_.map(at);
        body_ += QStringLiteral("<text x=\"%1\" y=\"%2\" font-family=\"%3\" font-size=\"%4\"%5%6>%7</text>\n")
                     .arg(number(place.x()), number(place.y()), font.family().toHtmlEscaped(),
                          number(QFontInfo(font).pixelSize() * scale()),
                          font.weight() >= QFont::DemiBold ? QStringLiteral(" font-weight=\"600\"") : QString(),
                          colorOf("fill", pen_.color()), item.text().toHtmlEscaped());
    }

    const QString& body() const { return body_; }

private:
    double scale() const { return std::sqrt(std::abs(transform_.determinant())); }

    QString fill(bool area) const {
        return area && brush_.style() != Qt::NoBrush ? colorOf("fill", brush_.color())
                                                     : QStringLiteral(" fill=\"none\"");
    }

    QString stroke() const {
        if (pen_.style() == Qt::NoPen)
            return {};
        const double width = std::max(pen_.widthF(), 0.5) * (pen_.isCosmetic() ? 1.0 : scale());
        QString text = colorOf("stroke", pen_.color()) + QStringLiteral(" stroke-width=\"%1\"").arg(number(width));
        QStringList dashes;
        for (const qreal dash : pen_.dashPattern())
            dashes << number(dash * width);
        if (!dashes.isEmpty())
            text += QStringLiteral(" stroke-dasharray=\"%1\"").arg(dashes.join(u' '));
        return text;
    }

    QString body_;
    QPen pen_;
    QBrush brush_;
    QTransform transform_;
};

SvgPaint::SvgPaint(const QSizeF& size, const QString& title)
    : size_(size)
    , title_(title)
    , engine_(std::make_unique<SvgPaintEngine>()) {}

SvgPaint::~SvgPaint() = default;

QPaintEngine* SvgPaint::paintEngine() const {
    return engine_.get();
}

QByteArray SvgPaint::document() const {
    const QString size = QStringLiteral("width=\"%1\" height=\"%2\" viewBox=\"0 0 %1 %2\"")
                             .arg(number(size_.width()), number(size_.height()));
    const QString start = QStringLiteral("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                         "<svg xmlns=\"http://www.w3.org/2000/svg\" %1>\n<title>%2</title>\n")
                              .arg(size, title_.toHtmlEscaped());
    return start.toUtf8() + engine_->body().toUtf8() + "</svg>\n";
}

int SvgPaint::metric(PaintDeviceMetric metric) const {
    switch (metric) {
    case PdmWidth:
        return static_cast<int>(std::ceil(size_.width()));
    case PdmHeight:
        return static_cast<int>(std::ceil(size_.height()));
    case PdmWidthMM:
        return static_cast<int>(size_.width() * 25.4 / dots_per_inch);
    case PdmHeightMM:
        return static_cast<int>(size_.height() * 25.4 / dots_per_inch);
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
        return dots_per_inch;
    case PdmDevicePixelRatio:
        return 1;
    default:
        return QPaintDevice::metric(metric);
    }
}

} // namespace usar::widgets
