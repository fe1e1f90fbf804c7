// Instruments for one figure: a big number with its unit, and a horizontal bar.
#pragma once

#include <optional>

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

/// Caption on the left, figure on the right, the bar between them. An unknown value is drawn as an empty, hatched bar
/// with a dash. The color changes to the caution and danger colors from those limits on, and a "!" precedes the figure.
/// GUI thread.
class Meter : public Instrument {
    Q_OBJECT
public:
    explicit Meter(const QString& caption, QWidget* parent = nullptr);

    /// In percent, 0..100; nullopt: unknown.
    void setValue(std::optional<double> value_pct);
    std::optional<double> value() const { return value_pct_; }
    /// High values are bad from these limits on; above 100 means never.
    void setLimits(double caution_pct, double danger_pct);
    QSize sizeHint() const override { return {240, fontMetrics().height() + 2}; }
    QSize minimumSizeHint() const override { return {160, fontMetrics().height() + 2}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString caption_;
    std::optional<double> value_pct_;
    double caution_pct_ = 101.0;
    double danger_pct_ = 101.0;
};

} // namespace usar::widgets
