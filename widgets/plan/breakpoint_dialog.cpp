#include "widgets/plan/breakpoint_dialog.h"

#include <array>
#include <limits>
#include <utility>

#include "core/posh/language/plan_reader.h"
#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

namespace {

using posh::ActResult;
using posh::BreakOn;

using Choice = std::pair<BreakOn, ActResult>;

/// Every event that a breakpoint can stop on, with one entry for each answer of an act.
constexpr std::array choices{
    Choice{BreakOn::Before, ActResult::Failed},        Choice{BreakOn::After, ActResult::Failed},
    Choice{BreakOn::Result, ActResult::Failed},        Choice{BreakOn::Result, ActResult::Running},
    Choice{BreakOn::Result, ActResult::RunningOnce},   Choice{BreakOn::Result, ActResult::Finished},
    Choice{BreakOn::VerdictChange, ActResult::Failed}, Choice{BreakOn::Interruption, ActResult::Failed}};

constexpr std::array pinned_results{ActResult::Failed, ActResult::Running, ActResult::RunningOnce, ActResult::Finished};

} // namespace

BreakpointDialog::BreakpointDialog(posh::Breakpoint breakpoint, QWidget* parent)
    : QDialog(parent)
    , breakpoint_(std::move(breakpoint))
    , on_(new QComboBox(this))
    , condition_(new QLineEdit(QString::fromStdString(breakpoint_.condition), this))
    , complaint_(makeLabel(this, "danger"))
    , from_hit_(new QSpinBox(this))
    , once_(new QCheckBox(tr("Only once, then off"), this))
    , enabled_(new QCheckBox(tr("On"), this)) {
    setWindowTitle(tr("Breakpoint"));
    posh::Breakpoint shown = breakpoint_;
    if (breakpoint_.on == BreakOn::Written) // Being written is the only event of a key.
        on_->addItem(breakOnText(breakpoint_));
    else
        for (const auto& [on, result] : choices) {
            shown.on = on;
            shown.result = result;
            on_->addItem(breakOnText(shown));
            if (on == breakpoint_.on && (on != BreakOn::Result || result == breakpoint_.result))
                on_->setCurrentIndex(on_->count() - 1);
        }
    on_->setAccessibleName(tr("When it stops"));
    condition_->setAccessibleName(tr("Condition"));
    condition_->setPlaceholderText(tr("always; or as a trigger: (distance 0.3 <) (bumped)"));
    condition_->setMinimumWidth(360);
    from_hit_->setRange(1, std::numeric_limits<int>::max());
    from_hit_->setValue(static_cast<int>(std::min<std::uint64_t>(breakpoint_.skip, 1'000'000'000)) + 1);
    from_hit_->setAccessibleName(tr("First hit that stops"));
    tellRange(from_hit_, tr("The plan stops at this hit of the breakpoint and at all later ones"));
    once_->setChecked(breakpoint_.once);
    enabled_->setChecked(breakpoint_.enabled);
    auto* form = laidOut(new QFormLayout(this), gap::small);
    form->addRow(makeLabel(this, "title", QString::fromStdString(breakpoint_.names)));
    form->addRow(tr("&Stop"), on_);
    form->addRow(tr("&If"), condition_);
    form->addRow(complaint_);
    form->addRow(tr("&From hit"), from_hit_);
    form->addRow(once_);
    form->addRow(enabled_);
    ok_ = addDialogButtons(form);
    connect(condition_, &QLineEdit::textChanged, this, &BreakpointDialog::check);
    check();
}

posh::Breakpoint BreakpointDialog::breakpoint() const {
    posh::Breakpoint typed = breakpoint_;
    if (breakpoint_.on != BreakOn::Written) {
        const auto& [on, result] = choices[static_cast<std::size_t>(std::max(0, on_->currentIndex()))];
        typed.on = on;
        if (on == BreakOn::Result)
            typed.result = result;
    }
    typed.condition = condition_->text().trimmed().toStdString();
    typed.skip = static_cast<std::uint64_t>(from_hit_->value() - 1);
    typed.once = once_->isChecked();
    typed.enabled = enabled_->isChecked();
    return typed;
}

void BreakpointDialog::check() {
    const auto fine = posh::Breakpoints::checkCondition(condition_->text().trimmed().toStdString());
    complaint_->setText(fine ? QString() : QString::fromStdString(fine.error().text()));
    complaint_->setVisible(!fine);
    ok_->setEnabled(fine.has_value());
}

PinDialog::PinDialog(const QString& call, const std::optional<QString>& answer, QWidget* parent)
    : QDialog(parent)
    , complaint_(makeLabel(this, "danger")) {
    setWindowTitle(tr("Force an answer"));
    auto* form = laidOut(new QFormLayout(this), gap::small);
    form->addRow(makeLabel(this, "title", call));
    auto* words = makeLabel(
        this, "muted",
        answer ? tr("Until you release it, the plan gets this answer, whatever the robot senses.")
               : tr("Until you release it, the robot does not do this and stands still; the plan gets this answer."));
    words->setMinimumWidth(320);
    form->addRow(words);
    QWidget* field = nullptr;
    if (answer) {
        field = answer_ = new QLineEdit(*answer, this);
        answer_->setPlaceholderText(tr("true, 0.3, 'high, \"text\" or nil"));
        answer_->selectAll();
        connect(answer_, &QLineEdit::textChanged, this, &PinDialog::check);
    } else {
        field = result_ = new QComboBox(this);
        for (const ActResult result : pinned_results)
            result_->addItem(resultText(result));
    }
    field->setAccessibleName(tr("Answer"));
    form->addRow(tr("&Answer"), field);
    form->addRow(complaint_);
    ok_ = addDialogButtons(form);
    field->setFocus();
    check();
}

std::optional<posh::Value> PinDialog::answer() const {
    return answer_ ? posh::readValue(answer_->text().toStdString()) : std::nullopt;
}

posh::ActResult PinDialog::result() const {
    return pinned_results[static_cast<std::size_t>(result_ ? std::max(0, result_->currentIndex()) : 0)];
}

void PinDialog::check() {
    const bool fine = result_ || answer();
    complaint_->setText(fine ? QString()
                             : tr("This is not a value. Write true, false, a number, 'a-symbol, \"a text\" or nil."));
    complaint_->setVisible(!fine);
    ok_->setEnabled(fine);
}

} // namespace usar::widgets
