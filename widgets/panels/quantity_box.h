// Number editor for scrolling forms: decimal point in every locale, no trailing zeros.
#pragma once

#include <QDoubleSpinBox>

namespace usar::widgets {

/// The wheel scrolls the form unless the box has the focus; a decimal comma is read as a point; a number out of range
/// is clamped to its bound. With a `specialValueText` its words may be typed as well. The value is reported when it is
/// committed (Return, arrows, loss of focus), not at every key. Unlike Qt's own box it accepts any number while typing,
/// so that the user sees it being clamped.
class QuantityBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityBox(QWidget* parent = nullptr);

    /// Uses as many decimals as the value needs, at most `decimals()`.
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    bool isSpecial(const QString& text) const;
    /// Returns `text` without the unit and with a decimal point.
    QString numberIn(QString text) const;
};

} // namespace usar::widgets
