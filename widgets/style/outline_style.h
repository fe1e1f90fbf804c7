// Variant of the Fusion style with visible outlines: on dark themes Fusion's own are darker than the background.
#pragma once

#include <QProxyStyle>

namespace usar::widgets {

/// Gives check boxes an outline with a contrast of at least 3:1, and fields and spin boxes of the dark theme a
/// hairline; the focused widget keeps Fusion's focus ring. Reads the current theme's tokens while painting, so it need
/// not be told about a new theme. GUI thread.
class OutlineStyle : public QProxyStyle {
public:
    OutlineStyle();
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

} // namespace usar::widgets
