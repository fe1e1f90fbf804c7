// A horizontal bar with its caption and its figure: battery, progress.
#pragma once

#include <optional>

#include <QWidget>

namespace usar::widgets {

/// Caption on the left, figure on the right, the bar between them. Unknown draws an empty, hatched bar and a dash. The
/// color turns to caution beyond `caution` and to danger beyond `danger`, and the figure then says so by a "!".
class Meter : public QWidget {
    Q_OBJECT
public:
    explicit Meter(const QString& caption, QWidget* parent = nullptr);

    /// Per cent, 0..100.
    void setValue(std::optional<double> value_pct);
    std::optional<double> value() const { return value_pct_; }
    /// Rising values are bad from here on; above 100 means never.
    void setLimits(double caution_pct, double danger_pct);
    /// Grey and struck: nobody vouches for the figure any more.
    void setStale(bool stale);
    bool stale() const { return stale_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString caption_;
    std::optional<double> value_pct_;
    double caution_pct_ = 101.0;
    double danger_pct_ = 101.0;
    bool stale_ = false;
};

} // namespace usar::widgets
