// The plan of a robot with its tools: search, list of what is running, and why a part runs or does not.
#pragma once

#include <functional>
#include <optional>

#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QToolButton>

#include "core/agent/published.h"
#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/models/plan/plan_reasons.h"
#include "widgets/plan/plan_text_edit.h"
#include "widgets/plan/plan_time_bar.h"
#include "widgets/plan/plan_view.h"
#include "widgets/style/section_stack.h"

namespace usar::widgets {

/// State comes in by setters, wishes go out by signals. A narrow panel stacks what a wide one shows side by side; in a
/// low one the lists are in tabs. GUI thread.
class PlanPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlanPanel(QWidget* parent = nullptr);

    PlanView& view() { return *view_; }
    /// Shows a plan in the drawing; see PlanView::setPlan.
    void setPlan(const posh::Plan& plan) { view_->setPlan(plan); }
    /// Also shows the plan's blackboard.
    void setSnapshot(PlanSnapshot snapshot);
    /// The selected key of the plan's blackboard; empty: none.
    QString selectedKey() const;
    /// Marks the keys of the blackboard that a breakpoint watches.
    void setWatchedKeys(const QStringList& keys);
    /// Sets the text that the plan was read from, shown beside the drawing and in step with it, and the findings of its
    /// reader. Call it after setPlan; without it the button that shows the text is disabled.
    void setPlanText(std::string_view text, const posh::Findings& findings);
    /// Removes plan, text and blackboard.
    void clear();
    /// Lists the breakpoints of this plan; the list is hidden while there are none.
    void setBreakpoints(const std::vector<BreakpointRow>& rows);
    PlanHaltBar& haltBar() { return *halt_bar_; }
    PlanTimeBar& timeBar() { return *time_bar_; }
    PlanTextEdit& textEdit() { return *text_; }

    QSize sizeHint() const override { return {1100, 420}; }
    QSize minimumSizeHint() const override { return {240, 170}; }

signals:
    /// The user wants to save the drawing as a picture.
    void exportRequested();
    /// The user enabled or disabled a breakpoint in the list.
    void breakpointSwitched(usar::agent::BreakpointId id, bool on);
    /// The user wants to edit this breakpoint.
    void breakpointEditRequested(usar::agent::BreakpointId id);
    /// The user wants to remove this breakpoint.
    void breakpointRemoved(usar::agent::BreakpointId id);
    /// The selection in the blackboard's list changed; see selectedKey.
    void keySelected();
    /// Double-click or Return: toggles whether the plan stops when the selected key is written.
    void keyActivated();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QBoxLayout* makeSearchRow();
    QBoxLayout* makeButtonRow();
    QWidget* makeText();
    /// Fills the side with the lists: running, reasons, blackboard, breakpoints.
    void fillSide();
    void connectBreakpoints();
    /// Grays out breakpoints that have no place in the plan.
    void inkBreakpoints();
    void showBoard();
    QListWidget* makeList(const QString& name, const QString& help);
    QToolButton* addButton(QBoxLayout* row, const char* icon_name, const QString& help,
                           const std::function<void()>& clicked = {});
    void showTree();
    void search(const QString& words);
    void showFound();
    void showRunning();
    void showReasons();
    /// Marks the selected part in the text.
    void showTextPlace();
    /// Tints the lines of running parts.
    void showRunningLines();
    void showFinding();
    /// Lists what prevents the drives that do not run.
    void showDriveRefusals();
    void showReasonRows(const std::vector<PlanReason>& reasons);
    /// Selects the part that a list item refers to.
    void jumpTo(const QListWidgetItem* item);
    /// The same, and asks for the time at which the item's reason began, if it has one.
    void activate(const QListWidgetItem* item);
    void askForTime(const std::optional<Seconds>& time);

    PlanView* view_;
    QLineEdit* search_;
    QLabel* found_;
    QToolButton* previous_;
    QToolButton* next_;
    QToolButton* text_shown_;
    QBoxLayout* head_;
    QSplitter* body_;
    PlanTextEdit* text_;
    QLabel* finding_;
    SectionStack* side_;
    QLabel* running_title_;
    QListWidget* running_;
    QLabel* verdict_;
    QListWidget* reasons_;
    std::optional<Seconds> pressed_since_; ///< time of the reason that the mouse was pressed on
    bool double_clicked_ = false;          ///< the release that ends a double-click is still to come
    QListWidget* board_;
    std::vector<BoardValue> board_values_;
    QStringList watched_keys_;
    QListWidget* breakpoints_;
    PlanHaltBar* halt_bar_;
    PlanTimeBar* time_bar_;
    bool slider_waits_ = false; ///< it had the focus before its tree was emptied, and gets it back
    bool from_text_ = false;    ///< the selection follows the cursor in the text
    int narrow_ = -1;           ///< 1: narrow layout, 0: wide; -1: not arranged yet
};

} // namespace usar::widgets
