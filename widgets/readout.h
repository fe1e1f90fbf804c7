// One figure of the instruments: a big number that keeps its place, its unit muted, its caption below.
#pragma once

#include <QWidget>

namespace usar::widgets {

/// The figure is right-aligned before its unit. `sample` is the widest text that will ever be shown; the width is
/// reserved for it.
class Readout : public QWidget {
    Q_OBJECT
public:
    Readout(const QString& caption, const QString& unit, const QString& sample, QWidget* parent = nullptr);

    /// Already formatted, without its unit; the same text again costs nothing.
    void setText(const QString& text);
    const QString& text() const { return text_; }
    /// Grey and struck: nobody vouches for the figure any more.
    void setStale(bool stale);
    bool stale() const { return stale_; }
    /// Of the figure alone: readouts above each other line up where theirs are equal.
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
    bool stale_ = false;
};

} // namespace usar::widgets
