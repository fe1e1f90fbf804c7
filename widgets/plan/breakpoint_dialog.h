// Dialog that edits a breakpoint: on which event it stops, on which condition, and from which hit.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "core/posh/run/breakpoints.h"

namespace usar::widgets {

/// Checks the condition while it is typed and shows what is wrong with it; OK is disabled until it is valid. GUI
/// thread.
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

} // namespace usar::widgets
