// The plan of a robot with what one needs around it: search, what runs now, and why a part runs or does not.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QToolButton>

#include "widgets/plan_halt_bar.h"
#include "widgets/plan_text_edit.h"
#include "widgets/plan_time_bar.h"
#include "widgets/plan_view.h"
#include "widgets/section_stack.h"

namespace usar::widgets {

/// A breakpoint in the panel's list.
struct BreakpointRow {
    int id = 0;
    QString text;
    QString help;
    std::string path; ///< in the plan; empty: it has no such place
    bool enabled = true;
    bool operator==(const BreakpointRow&) const = default;
};

/// Values in by setters, wishes out by signals. A narrow panel stacks what a broad one has side by side; the lists of a
/// low one stand behind tabs. GUI thread.
class PlanPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlanPanel(QWidget* parent = nullptr);

    PlanView& view() { return *view_; }
    void setPlan(const posh::Plan& plan) { view_->setPlan(plan); }
    void setSnapshot(PlanSnapshot snapshot);
    /// Of the plan's blackboard, the selected one; empty: none is.
    QString selectedKey() const;
    /// Keys of the blackboard that a breakpoint watches.
    void setWatchedKeys(const QStringList& keys);
    /// The text that the plan was read from, beside the drawing and in step with it, and what is wrong with it: the
    /// findings of its reader. To be called after setPlan; without it the button that shows the text is off.
    void setPlanText(std::string_view text, const posh::Findings& findings);
    void clear();
    /// Of the plan; without any the list is hidden.
    void setBreakpoints(const std::vector<BreakpointRow>& rows);
    PlanHaltBar& haltBar() { return *halt_bar_; }
    PlanTimeBar& timeBar() { return *time_bar_; }
    PlanTextEdit& textEdit() { return *text_; }
    /// Silent. Fewer than two leave nothing to choose: the box is hidden.
    void setRobots(const QStringList& names, const QString& shown);
    QString shownRobot() const { return robots_->currentText(); }

    QSize sizeHint() const override { return {1100, 420}; }
    QSize minimumSizeHint() const override { return {240, 170}; }

signals:
    void robotChosen(const QString& name);
    /// The person wants to see where a part stands in the plan's text; the panel shows it if it has the text.
    void textRequested(const usar::posh::Spot& at);
    /// As a picture in a file.
    void exportRequested();
    void breakpointSwitched(int id, bool on);
    void breakpointEditRequested(int id);
    void breakpointRemoved(int id);
    void keySelected();
    /// By a double-click or Return: it is to stop the plan when it is written, or no more.
    void keyActivated();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QBoxLayout* makeSearchRow();
    QBoxLayout* makeButtonRow();
    QWidget* makeText();
    void fillSide();
    void addBreakpointList();
    void addBoard();
    void showBoard();
    QListWidget* makeList(const QString& name, const QString& help);
    QToolButton* addButton(QBoxLayout* row, const QString& icon_name, const QString& help);
    void arrange();
    void showTree();
    void search(const QString& words);
    void showFound();
    void showRunning();
    void showReasons();
    void showTextPlace();
    void showRunningLines();
    void showFinding();
    void jumpTo(const QListWidgetItem* item);

    PlanView* view_;
    QComboBox* robots_;
    QLineEdit* search_;
    QLabel* found_;
    QToolButton* previous_;
    QToolButton* next_;
    QToolButton* text_shown_;
    QToolButton* expanded_;
    QBoxLayout* head_;
    QSplitter* body_;
    PlanTextEdit* text_;
    QLabel* finding_;
    SectionStack* side_;
    QLabel* running_title_;
    QListWidget* running_;
    QLabel* verdict_;
    QListWidget* reasons_;
    QListWidget* board_;
    std::vector<BoardValue> board_values_;
    QStringList watched_keys_;
    QListWidget* breakpoints_;
    PlanHaltBar* halt_bar_;
    PlanTimeBar* time_bar_;
    bool slider_waits_ = false; ///< it had the focus before its tree was emptied, and gets it back
    bool from_text_ = false;    ///< the selection follows the text's cursor
    int narrow_ = -1;           ///< not yet arranged
};

} // namespace usar::widgets
