// Tooltips of controls that set a quantity: what it is, and its range with the unit, as the control itself has them.
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QSpinBox>
#include <QString>

namespace usar::widgets {

/// "0.5" for "0.500", "0" for "-0": without what says nothing.
QString withoutTrailingZeros(QString number);

/// "Range: 0.5 m to 25 m"; without `highest`: "Range: from 1".
QString rangeText(const QString& lowest, const QString& highest);

/// Gives the control its tooltip: `what` it sets, and below it the range. Range, suffix and decimals must be set
/// before; after a change of them the function is to be called again. `unit` is for boxes without a suffix.
void tellRange(QDoubleSpinBox* box, const QString& what, QString unit = {});
/// A range that ends with the largest int has no end for a person.
void tellRange(QSpinBox* box, const QString& what, QString unit = {});
/// A slider counts steps, so its ends come as texts with units.
void tellRange(QSlider* slider, const QString& what, const QString& lowest, const QString& highest);

} // namespace usar::widgets
