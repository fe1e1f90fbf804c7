#include "widgets/plan/pin_dialog.h"

#include <array>

#include "core/posh/language/plan_reader.h"
#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr std::array pinned_results{posh::ActResult::Failed, posh::ActResult::Running, posh::ActResult::RunningOnce,
                                    posh::ActResult::Finished};

} // namespace

PinDialog::PinDialog(const QString& call, const QString& question, QWidget* parent)
    : QDialog(parent)
    , complaint_(makeLabel(this, "danger")) {
    setWindowTitle(tr("Pin"));
    auto* form = new QFormLayout(this);
    form->setSpacing(gap::small);
    form->addRow(makeLabel(this, "title", call));
    auto* words = makeLabel(this, "muted", question);
    words->setMinimumWidth(320);
    form->addRow(words);
    complaint_->hide();
}

void PinDialog::add(QWidget* field) {
    auto* form = static_cast<QFormLayout*>(layout());
    field->setAccessibleName(tr("Answer"));
    form->addRow(tr("&Answer"), field);
    form->addRow(complaint_);
    ok_ = addDialogButtons(form);
    field->setFocus();
}

PinDialog* PinDialog::forSense(const QString& call, const QString& answer, QWidget* parent) {
    auto* dialog =
        new PinDialog(call, tr("Until you release it, the plan gets this answer, whatever the robot senses."), parent);
    dialog->answer_ = new QLineEdit(answer, dialog);
    dialog->answer_->setPlaceholderText(tr("true, 0.3, 'high, \"text\" or nil"));
    dialog->answer_->selectAll();
    connect(dialog->answer_, &QLineEdit::textChanged, dialog, &PinDialog::check);
    dialog->add(dialog->answer_);
    dialog->check();
    return dialog;
}

PinDialog* PinDialog::forAct(const QString& call, QWidget* parent) {
    auto* dialog = new PinDialog(
        call, tr("Until you release it, the robot does not do this and stands still; the plan gets this answer."),
        parent);
    dialog->result_ = new QComboBox(dialog);
    for (const posh::ActResult result : pinned_results)
        dialog->result_->addItem(resultText(result));
    dialog->add(dialog->result_);
    return dialog;
}

std::optional<posh::Value> PinDialog::answer() const {
    return answer_ ? posh::readValue(answer_->text().toStdString()) : std::nullopt;
}

posh::ActResult PinDialog::result() const {
    return pinned_results[static_cast<std::size_t>(result_ ? std::max(0, result_->currentIndex()) : 0)];
}

void PinDialog::check() {
    const bool fine = answer().has_value();
    complaint_->setText(fine ? QString()
                             : tr("This is not a value. Write true, false, a number, 'a-symbol, \"a text\" or nil."));
    complaint_->setVisible(!fine);
    ok_->setEnabled(fine);
}

} // namespace usar::widgets
