// Editor that shows the text and the drawing of a plan side by side, and writes, checks, fixes, compares and saves it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/posh/language/plan_export.h"
#include "widgets/plan/plan_editor_parts.h"

namespace usar::widgets {

/// The text is the only source: gestures in the drawing become edits of it, and one unlimited history, which saving
/// does not affect, undoes both. While the text cannot be parsed, the drawing shows the last readable plan. State comes
/// in by setters, wishes go out by signals; file dialogs belong to the window. GUI thread.
class PlanEditor : public QWidget, private PlanEditorParts {
    Q_OBJECT
public:
    explicit PlanEditor(QWidget* parent = nullptr);
    ~PlanEditor() override;

    /// The senses and acts of the robot that the plan is for: they fill palette and completion, and plans are checked
    /// against them. Empty: plans are checked by themselves.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    /// The plan that the robot is running now, for comparing; an empty text means none.
    void setRunningPlan(const QString& name, const std::string& text);
    /// Enables "Put into the robot", or says in its tooltip why not; hidden if `why_not` is empty, too.
    void setApplicable(bool applicable, const QString& why_not = {});
    /// Shows a new plan without a file; the undo history starts again.
    void setText(const std::string& text, const QString& name);
    /// Folder for copies of unsaved texts, which survive a crash; empty: no copies. Offers an existing copy at once.
    void setKeepingFolder(const QString& folder);
    /// Deletes the copy of the unsaved text, because the user discards the changes.
    void forgetKept() { file_.forgetKept(); }

    /// Opens a file; on error the editor stays as it was.
    Result<void> open(const QString& path);
    /// Saves the text, and continues with this file; on error the editor keeps its file.
    Result<void> save(const QString& path);
    /// Writes the plan in another dialect. Returns what that dialect cannot express, one sentence per loss.
    Result<QStringList> exportTo(const QString& path, posh::Dialect dialect);
    /// Saves the drawing; the extension .svg, .pdf or .png selects the format.
    Result<void> savePicture(const QString& path);

    const std::string& text() const { return text_->planText(); }
    /// Empty for a new plan.
    QString path() const { return file_.path(); }
    /// File name without its folder, or the name of a new plan.
    QString name() const { return file_.name(); }
    bool isModified() const { return text_->document()->isModified(); }
    /// The findings of the current text, including those of binding it to the robot.
    const posh::Findings& findings();
    /// The fixes known for the finding at the text's cursor.
    std::vector<posh::QuickFix> mends();

    PlanCanvas& canvas() { return *canvas_; }
    PlanCodeEdit& textEdit() { return *text_; }
    PlanPalette& palette() { return *palette_; }
    /// The action of a command by its name: "undo", "move_up", "wrap_pattern", …; an unknown name is a programming
    /// error (assertion).
    QAction* action(const QString& name) const;
    /// Checks and draws the current text now instead of after a short delay.
    void catchUp();

    QSize sizeHint() const override { return {1280, 720}; }
    QSize minimumSizeHint() const override { return {300, 240}; }

signals:
    void openRequested();
    /// Also emitted by "Save" while there is no file.
    void saveAsRequested();
    void exportRequested(usar::posh::Dialect dialect);
    void pictureRequested();
    /// The user wants this plan in the robot.
    void applyRequested(const std::string& text, const QString& name);
    void saved(const QString& path);
    /// "Save" could not write the file.
    void saveFailed(const usar::Error& error);
    /// Name or modified state changed.
    void titleChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class InPlace { Words, Rename, Trigger, Limit, Comment };
    struct Command;

    // In plan_editor_parts.cpp.
    QWidget* makeHead();
    QWidget* makeTextPane();
    QWidget* makeDrawingPane();
    QWidget* makeLists();
    QWidget* makeOffer();
    QListWidget* makeList(const QString& name, const QString& help);
    QToolButton* addButton(QBoxLayout* row, QAction* action);
    QToolButton* addMenuButton(QBoxLayout* row, const QString& help, const QString& icon_name, QMenu* menu);
    void arrange();

    // In plan_editor_commands.cpp.
    QAction* add(const Command& command, std::function<void()> run);
    QAction* actionOf(const QKeyEvent& event, bool in_drawing) const;
    void makeFileCommands();
    void makeEditCommands();
    void makePartCommands();
    void makeListCommands();
    void makeMenus();
    void enableCommands();
    void showMenu(int node, const QPoint& global);
    void showTextMenu(const QPoint& at);

    void connectAll();
    void edited();
    void check();
    /// Checks any text; stores the plan that was read unless `plan` is nullptr.
    posh::Findings check(std::string_view text, posh::Plan* plan) const;
    void draw();
    void showFindings();
    void showFindingAtCursor();
    void showMends();
    void showState();
    void followCursor(int line, int column);
    void followSelection();
    void jumpTo(const posh::Spot& at);
    void perform(const Result<posh::PlanEdit>& edit);
    void perform(const std::function<Result<posh::PlanEdit>(const std::string&, const posh::PlanPart&)>& edit);
    void enterWords(int node, const QString& words, int what);
    void editInPlace(InPlace what);
    void editValues();
    agent::PrimitiveDescription describe(const posh::Call& call, agent::PrimitiveKind kind) const;
    void addMemberAtSelection(bool before);
    void compareWith(const std::string& other, const QString& name);
    void showUsages();
    void swapSelected();
    void wrapRange(posh::FormKind kind);
    void offerKept();
    void offer(const QString& words, const QString& accept, std::function<void()> run);
    void saveNow();
    void say(const QString& words, bool refused = false);
    std::optional<posh::PlanPart> selectedPart();
    std::optional<posh::PlanPart> selectedCall();
    const PlanGestures* gestures();
    bool binds() const { return !primitives_.empty(); }
    bool isDrawn() const { return drawn_text_ == text_->planText(); }
};

} // namespace usar::widgets
