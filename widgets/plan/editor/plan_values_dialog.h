// Dialog for the values in a sense or a call of a plan: arguments by type and range, and the comparison of the answer.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/plan/editor/value_field.h"

namespace usar::widgets {

/// Accepts only values that a plan can contain. Arguments that the robot does not describe are edited as text. GUI
/// thread.
class PlanValuesDialog : public QDialog {
    Q_OBJECT
public:
    /// The first is for a sense and includes its comparison, the second for an act or a form.
    PlanValuesDialog(const agent::PrimitiveDescription& sense, posh::SenseTest test, QWidget* parent);
    PlanValuesDialog(const agent::PrimitiveDescription& act, posh::Call call, QWidget* parent);

    /// The call as edited so far.
    posh::Call call() const { return test().call; }
    /// The test as edited so far; without comparison in a dialog for an act.
    posh::SenseTest test() const;

private:
    struct ArgumentRow {
        std::optional<std::size_t> argument; ///< index in the call; nullopt: the call uses the default
        const agent::PoshParameter* parameter = nullptr;
        ValueField* field = nullptr;
    };
    /// The following add the parts of the form from top to bottom.
    void addHead();
    void addArguments();
    /// For an argument that the description does not list.
    void addUndeclared(std::size_t argument);
    void addComparison();
    void addEnd();
    /// Shows the resulting phrase and enables OK if all values are valid.
    void check();

    agent::PrimitiveDescription description_;
    posh::SenseTest first_;
    QFormLayout* form_;
    std::vector<ArgumentRow> arguments_;
    QComboBox* comparison_ = nullptr; ///< senses only
    ValueField* operand_ = nullptr;
    QLabel* phrase_ = nullptr;
    QPushButton* ok_ = nullptr;
};

} // namespace usar::widgets
