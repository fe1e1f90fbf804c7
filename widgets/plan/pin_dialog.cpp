#include "widgets/plan/pin_dialog.h"

#include <array>

#include <QFormLayout>
#include <QPushButton>

#include "core/posh/language/plan_reader.h"
#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr std::array pinned_results{posh::ActResult::Failed, posh::ActResult::Running, posh::ActResult::RunningOnce,
                                    posh::ActResult::Finished};

} // namespace

PinDialog::PinDialog(const QString& call, const QString& question, QWidget* parent)
    : QDialog(parent)
    , complaint_(new QLabel(this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Pin"));
    auto* form = new QFormLayout(this);
    form->setSpacing(gap::small);
    auto* title = new QLabel(call, this);
    title->setProperty("role", "title");
    form->addRow(title);
    auto* words = new QLabel(question, this);
    words->setProperty("role", "muted");
    words->setWordWrap(true);
    words->setMinimumWidth(320);
    form->addRow(words);
    complaint_->setProperty("role", "danger");
    complaint_->setWordWrap(true);
    complaint_->hide();
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PinDialog::add(const QString& label, QWidget* field) {
    auto* form = static_cast<QFormLayout*>(layout());
    form->addRow(label, field);
    form->addRow(complaint_);
    form->addRow(buttons_);
    field->setFocus();
}

PinDialog* PinDialog::forSense(const QString& call, const QString& answer, QWidget* parent) {
    auto* dialog =
        new PinDialog(call, tr("Until it is released the plan gets this answer, whatever the robot senses."), parent);
    dialog->answer_ = new QLineEdit(answer, dialog);
    dialog->answer_->setAccessibleName(tr("Answer"));
    dialog->answer_->setPlaceholderText(tr("true, 0.3, 'high, \"text\" or nil"));
    dialog->answer_->selectAll();
    connect(dialog->answer_, &QLineEdit::textChanged, dialog, &PinDialog::check);
    dialog->add(tr("&Answer"), dialog->answer_);
    dialog->check();
    return dialog;
}

PinDialog* PinDialog::forAct(const QString& call, QWidget* parent) {
    auto* dialog = new PinDialog(
        call, tr("Until it is released the robot does not do this and stands still; the plan gets this answer."),
        parent);
    dialog->result_ = new QComboBox(dialog);
    dialog->result_->setAccessibleName(tr("Answer"));
    for (const posh::ActResult result : pinned_results)
        dialog->result_->addItem(resultText(result));
    dialog->add(tr("&Answer"), dialog->result_);
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
    complaint_->setText(
        fine ? QString()
             : tr("This is no value of a plan. Write true, false, a number, 'a-symbol, \"a text\" or nil."));
    complaint_->setVisible(!fine);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(fine);
}

} // namespace usar::widgets
