// A number editor that behaves in a scrolling form: decimal point in every locale, no superfluous zeros.
#pragma once

#include <QDoubleSpinBox>

namespace usar::widgets {

/// The wheel scrolls the form unless the box has the focus; a decimal comma is taken for a point; a number
/// out of range is pulled to its bound. The value is told when it is committed (Return, arrows, focus lost), not at
/// every key. Unlike Qt's own box it lets any number be typed, so the bound can be seen to act.
class QuantityBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityBox(QWidget* parent = nullptr);

    /// As many decimals as the value needs, at most `decimals()`.
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    /// `text` without the unit, with a decimal point.
    QString numberIn(QString text) const;
};

} // namespace usar::widgets
