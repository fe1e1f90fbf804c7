// A number editor that behaves in a scrolling form: decimal point in every locale, no superfluous zeros.
#pragma once

#include <QDoubleSpinBox>

namespace usar::widgets {

/// The wheel scrolls the form unless the box has the focus; a decimal comma is taken for a point; the value is told
/// when it is committed (Return, arrows, focus lost), not at every key.
class QuantityBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityBox(QWidget* parent = nullptr);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

} // namespace usar::widgets
