// One parameter as a row of a form: mark, label, editor, reset button.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/agent/parameters.h"

namespace usar::widgets {

/// The editor depends on the type of the default: switch, number with unit, list of choices, or text. Keeps the exact
/// value, so showing an angle in degrees does not change it unless the user edits it. GUI thread.
class ParameterRow : public QWidget {
    Q_OBJECT
public:
    explicit ParameterRow(agent::ParameterSpec spec, QWidget* parent = nullptr);

    const agent::ParameterSpec& spec() const { return spec_; }
    /// The value in SI units and radians.
    const agent::ParameterValue& value() const { return value_; }
    /// Shows `value` without emitting; a value that does not fit the spec is replaced by the default.
    void setValue(const agent::ParameterValue& value);
    /// True if the value differs from the default by more than the rounding error of a conversion to degrees.
    bool modified() const;
    /// True if label, id, group or help contains `words`, ignoring case.
    bool matches(const QString& words) const;

signals:
    /// By the user only.
    void edited();

private:
    // Make the editor for each type of value; every editor has the spec's id as its object name.
    QWidget* makeEditor();
    QWidget* makeSwitch();
    QWidget* makeNumber();
    QWidget* makeChoice();
    QWidget* makeText();
    /// Stores the value of the editor and emits `edited`.
    void take(const agent::ParameterValue& value);
    /// Shows the value in the editor without emitting.
    void showValue();
    /// Shows whether the row is modified.
    void showMark();

    agent::ParameterSpec spec_;
    agent::ParameterValue value_; ///< exact, whatever the editor's decimals
    QWidget* mark_ = nullptr;
    QLabel* label_ = nullptr;
    QWidget* editor_ = nullptr;
    QToolButton* reset_ = nullptr;
};

} // namespace usar::widgets
