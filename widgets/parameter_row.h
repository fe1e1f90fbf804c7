// One parameter as a row of a form: mark, label, editor, reset button.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/agent/parameters.h"

namespace usar::widgets {

/// The editor follows the type of the default: switch, number with unit, list of choices or text. Keeps the exact
/// value, so an angle that nobody touched does not change by being shown in degrees. GUI thread.
class ParameterRow : public QWidget {
    Q_OBJECT
public:
    explicit ParameterRow(agent::ParameterSpec spec, QWidget* parent = nullptr);

    const agent::ParameterSpec& spec() const { return spec_; }
    const agent::ParameterValue& value() const { return value_; }
    /// Shows `value` without telling; one that does not fit the spec shows the default.
    void setValue(const agent::ParameterValue& value);
    /// Differs from the default by more than a trip through degrees can do.
    bool modified() const;
    /// Label, id, group or help contains `words`, whatever the case.
    bool matches(const QString& words) const;

signals:
    /// By the person only.
    void edited();

private:
    void build();
    // One editor for each type of value; all have the spec's id as object name.
    QWidget* makeEditor();
    QWidget* makeSwitch();
    QWidget* makeNumber();
    QWidget* makeChoice();
    QWidget* makeText();
    /// From the editor: keeps and tells.
    void take(const agent::ParameterValue& value);
    /// To the editor, in silence.
    void showValue();
    void showMark();

    agent::ParameterSpec spec_;
    agent::ParameterValue value_; ///< exact, whatever the editor's decimals
    QWidget* mark_ = nullptr;
    QLabel* label_ = nullptr;
    QWidget* editor_ = nullptr;
    QToolButton* reset_ = nullptr;
};

} // namespace usar::widgets
