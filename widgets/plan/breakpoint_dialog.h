// Dialogs for debugging a plan: one edits a breakpoint, the other asks which answer a sense or an act should give.
#pragma once

#include <optional>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "core/posh/run/breakpoints.h"
#include "core/posh/run/host.h"

namespace usar::widgets {

/// Edits on which event a breakpoint stops, on which condition, and from which hit. Checks the condition while it is
/// typed and shows what is wrong with it; OK is disabled until it is valid. GUI thread.
class BreakpointDialog : public QDialog {
    Q_OBJECT
public:
    /// Edits a copy of `breakpoint`.
    BreakpointDialog(posh::Breakpoint breakpoint, QWidget* parent);

    /// The breakpoint as edited so far; its condition may be invalid.
    posh::Breakpoint breakpoint() const;

private:
    /// Shows what is wrong with the condition and enables OK accordingly.
    void check();

    posh::Breakpoint breakpoint_;
    QComboBox* on_;
    QLineEdit* condition_;
    QLabel* complaint_;
    QSpinBox* from_hit_;
    QCheckBox* once_;
    QCheckBox* enabled_;
    QPushButton* ok_;
};

/// Asks which answer a sense or an act should give instead of the robot. GUI thread.
class PinDialog : public QDialog {
    Q_OBJECT
public:
    /// `call` is spelled as in traces. `answer` is the initial text for a sense, spelled as in a plan; nullopt makes a
    /// dialog for an act.
    PinDialog(const QString& call, const std::optional<QString>& answer, QWidget* parent);

    /// The typed value for a sense; nullopt while the text is not a value, and in a dialog for an act.
    std::optional<posh::Value> answer() const;
    /// The chosen result for an act; the first choice in a dialog for a sense.
    posh::ActResult result() const;

private:
    /// Shows whether the typed answer is a value, and enables OK accordingly.
    void check();

    QLineEdit* answer_ = nullptr;
    QComboBox* result_ = nullptr;
    QLabel* complaint_;
    QPushButton* ok_;
};

} // namespace usar::widgets
