// A paint device that writes SVG: what is painted on it becomes paths and text in a file that any viewer shows.
#pragma once

#include <memory>

#include <QPaintDevice>
#include <QSizeF>
#include <QString>

namespace usar::widgets {

class SvgPaintEngine;

/// Understands paths, lines, rectangles, ellipses and text in one color each; no pictures, gradients or clips, which
/// our drawings do not have. Text stays text. One painter at a time; read `document` when it has ended.
class SvgPaint : public QPaintDevice {
public:
    /// In pixels of 1/96 inch. The title is for people who hear it.
    SvgPaint(const QSizeF& size, const QString& title);
    ~SvgPaint() override;

    QPaintEngine* paintEngine() const override;
    /// The whole file.
    QByteArray document() const;

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    QSizeF size_;
    QString title_;
    std::unique_ptr<SvgPaintEngine> engine_;
};

} // namespace usar::widgets
