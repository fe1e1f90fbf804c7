// Dialog that asks which answer a sense or an act should give instead of the robot.
#pragma once

#include <optional>

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/posh/run/host.h"

namespace usar::widgets {

/// Either for a sense or for an act, depending on the function that makes it. GUI thread.
class PinDialog : public QDialog {
    Q_OBJECT
public:
    /// `call` is spelled as in traces; `answer` is the initial text, spelled as in a plan. Both dialogs belong to
    /// `parent`.
    static PinDialog* forSense(const QString& call, const QString& answer, QWidget* parent);
    static PinDialog* forAct(const QString& call, QWidget* parent);

    /// The typed value for a sense; nullopt while the text is not a value, and in a dialog for an act.
    std::optional<posh::Value> answer() const;
    /// The chosen result for an act; the first choice in a dialog for a sense.
    posh::ActResult result() const;

private:
    PinDialog(const QString& call, const QString& question, QWidget* parent);
    /// Adds the field for the answer, and what is below it.
    void add(QWidget* field);
    /// Shows whether the typed answer is a value, and enables OK accordingly.
    void check();

    QLineEdit* answer_ = nullptr;
    QComboBox* result_ = nullptr;
    QLabel* complaint_;
    QPushButton* ok_ = nullptr;
};

} // namespace usar::widgets
