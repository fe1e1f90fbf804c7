// Instrument for one figure: a big number in a fixed place, its unit muted, its caption below.
#pragma once

#include "widgets/style/sheet.h"

namespace usar::widgets {

/// The figure is right-aligned before its unit. `sample` is the widest text that will be shown; its width is reserved.
class Readout : public Instrument {
    Q_OBJECT
public:
    Readout(const QString& caption, const QString& unit, const QString& sample, QWidget* parent = nullptr);

    /// Sets the formatted figure without its unit; the same text again costs nothing.
    void setText(const QString& text);
    const QString& text() const { return text_; }
    /// Width of the figure alone, in pixels; readouts in a column line up if their widths are equal.
    int fieldWidth_px() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString caption_;
    QString unit_;
    QString sample_;
    QString text_;
};

} // namespace usar::widgets
