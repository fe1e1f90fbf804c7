// Asks what a sense or an act shall answer in place of the robot.
#pragma once

#include <optional>

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>

#include "core/posh/host.h"

namespace usar::widgets {

/// One of the two, by how it is made. GUI thread.
class PinDialog : public QDialog {
    Q_OBJECT
public:
    /// `call` as traces write it; `answer` is offered, as a plan writes values.
    static PinDialog* forSense(const QString& call, const QString& answer, QWidget* parent);
    static PinDialog* forAct(const QString& call, QWidget* parent);

    /// Nothing while no value is typed.
    std::optional<posh::Value> answer() const;
    posh::ActResult result() const;

private:
    PinDialog(const QString& call, const QString& question, QWidget* parent);
    void add(const QString& label, QWidget* field);
    void check();

    QLineEdit* answer_ = nullptr;
    QComboBox* result_ = nullptr;
    QLabel* complaint_;
    QDialogButtonBox* buttons_;
};

} // namespace usar::widgets
