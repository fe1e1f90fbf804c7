// Asks when a breakpoint stops a run: on what, on which condition, from which hit on.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "core/posh/breakpoints.h"

namespace usar::widgets {

/// Takes nothing that cannot be set: what is wrong with the condition is said while it is typed. GUI thread.
class BreakpointDialog : public QDialog {
    Q_OBJECT
public:
    BreakpointDialog(posh::Breakpoint breakpoint, QWidget* parent);

    /// As it is typed now.
    posh::Breakpoint breakpoint() const;

private:
    void check();

    posh::Breakpoint breakpoint_;
    QComboBox* on_;
    QLineEdit* condition_;
    QLabel* complaint_;
    QSpinBox* from_hit_;
    QCheckBox* once_;
    QCheckBox* enabled_;
    QDialogButtonBox* buttons_;
};

} // namespace usar::widgets
