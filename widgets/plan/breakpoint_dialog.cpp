#include "widgets/plan/breakpoint_dialog.h"

#include <array>
#include <limits>
#include <span>
#include <utility>

#include <QFormLayout>
#include <QPushButton>

#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

using posh::ActResult;
using posh::BreakOn;

using Choice = std::pair<BreakOn, ActResult>;

/// Every event that a breakpoint can stop on, with one entry for each answer of an act.
constexpr std::array all_choices{
    Choice{BreakOn::Before, ActResult::Failed},        Choice{BreakOn::After, ActResult::Failed},
    Choice{BreakOn::Result, ActResult::Failed},        Choice{BreakOn::Result, ActResult::Running},
    Choice{BreakOn::Result, ActResult::RunningOnce},   Choice{BreakOn::Result, ActResult::Finished},
    Choice{BreakOn::VerdictChange, ActResult::Failed}, Choice{BreakOn::Interruption, ActResult::Failed}};
constexpr std::span<const Choice> choices = all_choices;

} // namespace

BreakpointDialog::BreakpointDialog(posh::Breakpoint breakpoint, QWidget* parent)
    : QDialog(parent)
    , breakpoint_(std::move(breakpoint))
    , on_(new QComboBox(this))
    , condition_(new QLineEdit(QString::fromStdString(breakpoint_.condition), this))
    , complaint_(new QLabel(this))
    , from_hit_(new QSpinBox(this))
    , once_(new QCheckBox(tr("Only once, then off"), this))
    , enabled_(new QCheckBox(tr("On"), this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Breakpoint"));
    if (breakpoint_.on == BreakOn::Written) // Being written is the only event of a key.
        on_->addItem(breakOnText(breakpoint_));
    for (const auto& [on, result] : breakpoint_.on == BreakOn::Written ? std::span<const Choice>() : choices) {
        posh::Breakpoint shown;
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
    complaint_->setProperty("role", "danger");
    complaint_->setWordWrap(true);
    from_hit_->setRange(1, std::numeric_limits<int>::max());
    from_hit_->setValue(static_cast<int>(std::min<std::uint64_t>(breakpoint_.skip, 1'000'000'000)) + 1);
    from_hit_->setAccessibleName(tr("First hit that stops"));
    once_->setChecked(breakpoint_.once);
    enabled_->setChecked(breakpoint_.enabled);
    auto* form = new QFormLayout(this);
    form->setSpacing(gap::small);
    auto* place = new QLabel(QString::fromStdString(breakpoint_.names), this);
    place->setWordWrap(true);
    place->setProperty("role", "title");
    form->addRow(place);
    form->addRow(tr("&Stop"), on_);
    form->addRow(tr("&If"), condition_);
    form->addRow(complaint_);
    form->addRow(tr("&From hit"), from_hit_);
    form->addRow(once_);
    form->addRow(enabled_);
    form->addRow(buttons_);
    connect(condition_, &QLineEdit::textChanged, this, &BreakpointDialog::check);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
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
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(fine.has_value());
}

} // namespace usar::widgets
