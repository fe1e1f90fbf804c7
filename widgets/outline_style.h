// Fusion with outlines that can be seen: on a dark ground its own are darker than the ground.
#pragma once

#include <QProxyStyle>

namespace usar::widgets {

/// Check boxes get an outline of 3:1 and more against the ground, fields and spin boxes on dark a hairline; what has
/// the focus keeps Fusion's ring. Made from the tokens of the moment, so that it needs no news of another theme. GUI
/// thread.
class OutlineStyle : public QProxyStyle {
public:
    OutlineStyle();
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

} // namespace usar::widgets
