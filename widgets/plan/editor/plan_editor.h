// Editor that shows the text and the drawing of a plan side by side, and writes, checks, fixes, compares and saves it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QSplitter>
#include <QTimer>

#include "widgets/models/plan/plan_checker.h"
#include "widgets/plan/editor/plan_code_edit.h"
#include "widgets/plan/editor/plan_editor_head.h"
#include "widgets/plan/editor/plan_file.h"
#include "widgets/plan/editor/plan_lists.h"
#include "widgets/plan/editor/plan_palette.h"
#include "widgets/plan/editor/plan_part_commands.h"
#include "widgets/plan/editor/plan_part_editor.h"

namespace usar::widgets {

/// The text is the only source: gestures in the drawing become edits of it, and one unlimited history, which saving
/// does not affect, undoes both. While the text cannot be parsed, the drawing shows the last readable plan. GUI thread.
class PlanEditor : public QWidget {
    Q_OBJECT
public:
    explicit PlanEditor(QWidget* parent = nullptr);

    /// The senses and acts of the robot that the plan is for: they fill palette and completion, and plans are checked
    /// against them. Empty: plans are checked without a robot.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    /// The plan that the robot is running now, for comparing; an empty text means none.
    void setRunningPlan(const QString& name, const std::string& text);
    /// Enables "Load into robot", or says in its tooltip why not; hidden if `why_not` is empty, too.
    void setApplicable(bool applicable, const QString& why_not = {}) { head_->setApplicable(applicable, why_not); }
    /// Shows a new plan without a file; the undo history starts again.
    void setText(const std::string& text, const QString& name);
    /// Folder for copies of unsaved texts, which survive a crash; empty: no copies. Offers an existing copy at once.
    void setKeepingFolder(const QString& folder);
    /// Calls `go_on` at once if nothing would be lost, otherwise after the user has saved or discarded the changes;
    /// never if the user cancels. A second call while the question is open replaces the first one's `go_on`.
    void letGo(const std::function<void()>& go_on);

    /// Opens a file; on error the editor stays as it was.
    Result<void> open(const QString& path);
    /// Saves the text, and continues with this file; on error the editor keeps its file.
    Result<void> save(const QString& path);
    /// Writes the plan in another dialect. Returns what that dialect cannot express, one sentence per loss.
    Result<QStringList> exportTo(const QString& path, posh::Dialect dialect);
    /// Saves the drawing; the extension .svg, .pdf or .png selects the format.
    Result<void> savePicture(const QString& path);

    const std::string& text() const { return text_->planText(); }
    QString path() const { return file_.path(); } ///< empty for a new plan
    /// File name without its folder, or the name of a new plan.
    QString name() const { return file_.name(); }
    bool isModified() const { return text_->document()->isModified(); }
    /// The findings of the current text, including those of binding it to the robot.
    const posh::Findings& findings();
    /// The fixes known for the finding at the text's cursor.
    std::vector<posh::QuickFix> fixes();

    PlanCanvas& canvas() { return *canvas_; }
    PlanCodeEdit& textEdit() { return *text_; }
    PlanPalette& palette() { return *palette_; }
    /// The action of a command by its name: "undo", "move_up", "wrap_pattern", …; an unknown name is a programming
    /// error (assertion).
    QAction* action(const QString& name) const { return actions_.action(name); }
    /// Checks and draws the current text now instead of after a short delay.
    void catchUp();

    QSize sizeHint() const override { return {1280, 720}; }
    QSize minimumSizeHint() const override { return {300, 240}; }

signals:
    void openRequested();
    /// The user wants this plan in the robot.
    void applyRequested(const std::string& text, const QString& name);
    void saved(const QString& path);
    /// `lacks`: what the dialect cannot express, one sentence per loss.
    void exported(const QString& path, const QStringList& lacks);
    /// A file that the user wanted could not be written.
    void failed(const usar::Error& error);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addWidgets();
    void connectAll();

    // In plan_editor_dialogs.cpp. `then`, if any, is called when the plan is saved.
    void saveNow(const std::function<void()>& then = {});
    void chooseWhereToSave(const std::function<void()>& then = {});
    void chooseWhereToExport(posh::Dialect dialect);
    void chooseWhereToDraw();

    // In plan_editor_commands.cpp.
    void addFileCommands();
    void addEditCommands();
    void enableCommands();
    void showTextMenu(const QPoint& at);
    void edited();
    void check();
    void draw();
    void showFindings();
    void showFixes();
    void showState();
    /// Selects in the drawing what is at the cursor of the text, and marks in the text what is selected in the drawing.
    void followCursor(int line, int column);
    void followSelection();
    void jumpTo(const posh::Spot& at);
    void apply(const posh::PlanEdit& edit);
    void compareWith(const std::string& other, const QString& name);
    /// Shows another text from its beginning, with a history of its own.
    void startWith(const std::string& text);
    void offerKept();
    void takeChangeOnDisk(const std::string& text);
    /// Shows a line below the panes; empty hides it. `refused`: something was not done.
    void say(const QString& words, bool refused = false);

    PlanFile file_;
    PlanChecker checker_;
    PlanActions actions_{*this};
    PlanEditorMenus menus_;
    PlanEditorHead* head_ = nullptr;
    PlanOfferBar* offer_ = nullptr;
    QSplitter* body_ = nullptr;
    QSplitter* column_ = nullptr;
    PlanPalette* palette_ = nullptr;
    PlanTextPane* text_pane_ = nullptr;
    PlanCodeEdit* text_ = nullptr; ///< child of text_pane_
    PlanDrawingPane* drawing_ = nullptr;
    PlanCanvas* canvas_ = nullptr;    ///< child of drawing_
    PlanPartEditor* parts_ = nullptr; ///< child of drawing_
    PlanLists* lists_ = nullptr;
    QLabel* state_ = nullptr;
    PlanPartCommands* part_commands_ = nullptr;
    QString running_name_;
    std::string running_text_;
    QTimer check_timer_;
    QTimer draw_timer_;
    /// The text is changing the drawing, or the drawing the text; prevents an endless loop of updates.
    bool from_text_ = false;
    bool from_drawing_ = false;
    int narrow_ = -1; ///< 1: narrow layout, 0: wide; -1: not arranged yet
};

} // namespace usar::widgets
