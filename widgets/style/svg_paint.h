// Paint device that writes SVG: whatever is painted becomes paths and text in a file that any viewer can show.
#pragma once

#include <memory>

#include <QPaintDevice>
#include <QSizeF>
#include <QString>

namespace usar::widgets {

class SvgPaintEngine;

/// Supports paths, lines, rectangles, ellipses and text in solid colors; no pictures, gradients or clipping, which our
/// drawings do not use. Text stays text. One painter at a time; call `document` after it has ended.
class SvgPaint : public QPaintDevice {
public:
    /// `size` is in pixels of 1/96 inch. The title is read by screen readers.
    SvgPaint(const QSizeF& size, const QString& title);
    ~SvgPaint() override;

    /// The engine that collects elements; owned by this device.
    QPaintEngine* paintEngine() const override;
    /// The complete file.
    QByteArray document() const;

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    QSizeF size_;
    QString title_;
    std::unique_ptr<SvgPaintEngine> engine_;
};

} // namespace usar::widgets
