// Form for the parameters of a behavior, generated from their specs: grouped, searchable, usable at a width of 280 px.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

#include "core/agent/parameters.h"
#include "widgets/style/form_parts.h"

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
    /// Makes the editor for the type of value and sets `show_in_editor_`.
    QWidget* makeEditor();
    QWidget* makeNumber();
    QWidget* makeChoice();
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
    QWidget* editor_ = nullptr; ///< has the spec's id as its object name
    std::function<void()> show_in_editor_;
    QToolButton* reset_ = nullptr;
};

class EmptyState;

/// Values are set by setters, edits are reported by `changed`. Values are in SI units and radians; angles are shown and
/// edited in degrees. Values set for one list of specs are kept while another list is shown. A modified row has a bar
/// at its left, a bold label and a button that restores the default. Search and "modified only" hide rows and never
/// change values. GUI thread; rows belong to the form.
class ParameterForm : public QWidget {
    Q_OBJECT
public:
    /// Values by the ids of their parameters.
    using Values = std::map<std::string, agent::ParameterValue>;

    explicit ParameterForm(QWidget* parent = nullptr);

    /// Shows rows for these specs, in groups in the order of first appearance. The same specs again change nothing;
    /// others start with the values that they had when they were last shown, else with their defaults.
    void setSpecs(const std::vector<agent::ParameterSpec>& specs);
    /// Offers these sets of values above the rows, beside the defaults; without any there is no choice. Their values
    /// fit the specs.
    void setPresets(const std::vector<agent::ParameterPreset>& presets);
    /// Ids without a row are ignored, and rows that are not in `values` keep their value; a value that does not fit its
    /// spec is replaced by the default. Does not emit `changed`.
    void setValues(const Values& values);
    /// All values by id, also those of hidden rows.
    Values values() const;
    /// The values that differ from their defaults, which is what a mission file stores.
    Values modified() const;

    QSize sizeHint() const override { return {320, 400}; }

public slots:
    /// Restores all defaults; emits `changed` once, or not at all if nothing was modified.
    void resetAll();

signals:
    /// Emitted after every edit by the user, with all values.
    void changed(const std::map<std::string, usar::agent::ParameterValue>& values);

private:
    /// Parameters under a common header.
    struct Group {
        QLabel* header = nullptr;
        std::vector<ParameterRow*> rows;
    };

    /// Makes the row with the list of presets, which is hidden.
    QWidget* makePresetRow();
    /// Sets all rows to a preset's values and to the defaults of what it does not name.
    void choosePreset(int index);
    /// Shows in the list which preset has the values of the rows.
    void showPreset();
    /// Sets rows that are in `values` to them, and all others to their defaults; emits `changed`.
    void replaceValues(const Values& values);
    /// Makes the row with search line, "modified only" and "reset all".
    QWidget* makeTools();
    Group& groupOf(const std::string& name);
    void buildRows();
    /// The entry of kept_ for the current specs; empty if they were not shown before.
    Values& keptValues();
    void applyFilter();
    /// Emits `changed`; the edited row stays visible even if the filter would now hide it.
    void rowEdited();

    QWidget* preset_row_ = nullptr;
    QComboBox* presets_box_ = nullptr; ///< the defaults, the presets, and last what is none of them
    std::vector<agent::ParameterPreset> presets_;
    QLineEdit* search_;
    QToolButton* modified_only_;
    QToolButton* reset_all_; ///< visible only while something is modified
    QScrollArea* scroll_ = new QScrollArea(this);
    QLabel* nothing_ = mutedLabel({}, this); ///< says why the filter hides all rows
    EmptyState* empty_state_;
    std::vector<agent::ParameterSpec> specs_;
    std::vector<std::pair<std::string, Group>> groups_; ///< in the order of the specs
    std::vector<ParameterRow*> rows_;                   ///< the rows of all groups
    /// Modified values of each list of specs when it was last shown; there are few behaviors, so a linear search is
    /// enough.
    std::vector<std::pair<std::vector<agent::ParameterSpec>, Values>> kept_;
};

} // namespace usar::widgets
