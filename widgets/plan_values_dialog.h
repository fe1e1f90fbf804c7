// The values in a sense or a call of a plan: arguments by their types and ranges, and what the answer is compared with.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include "widgets/value_field.h"

namespace usar::widgets {

/// Takes nothing that the plan could not hold. What the robot does not describe is edited as words. GUI thread.
class PlanValuesDialog : public QDialog {
    Q_OBJECT
public:
    /// With the comparison.
    PlanValuesDialog(const agent::PrimitiveDescription& sense, posh::SenseTest test, QWidget* parent);
    PlanValuesDialog(const agent::PrimitiveDescription& act, posh::Call call, QWidget* parent);

    posh::Call call() const { return test().call; }
    /// As it is edited now.
    posh::SenseTest test() const;

private:
    struct ArgumentRow {
        std::optional<std::size_t> argument; ///< of the call; nothing: it takes the default
        const agent::PoshParameter* parameter = nullptr;
        ValueField* field = nullptr;
    };
    void addHead();
    void addArguments();
    void addUndeclared(std::size_t argument);
    void addComparison();
    void addEnd();
    void check();

    agent::PrimitiveDescription description_;
    posh::SenseTest first_;
    QFormLayout* form_;
    std::vector<ArgumentRow> arguments_;
    QComboBox* comparison_ = nullptr; ///< of a sense
    ValueField* operand_ = nullptr;
    QLabel* phrase_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace usar::widgets
