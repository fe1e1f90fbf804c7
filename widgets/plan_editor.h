// Text and drawing of a plan side by side, to be written, checked, mended, compared and saved.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/posh/plan_export.h"
#include "widgets/plan_editor_parts.h"

namespace usar::widgets {

/// The text is the only truth: gestures in the drawing become edits of it, and one history without limit, which saving
/// does not touch, undoes both. While the text cannot be read the drawing shows what it was before. Values in by
/// setters, wishes out by signals; file dialogs belong to the window. GUI thread.
class PlanEditor : public QWidget, private PlanEditorParts {
    Q_OBJECT
public:
    explicit PlanEditor(QWidget* parent = nullptr);
    ~PlanEditor() override;

    /// Of the robot that the plan is for: they fill palette and completion, and plans are checked against them. None:
    /// a plan is checked by itself.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    /// What the robot flies by now, for comparing; an empty text: nothing.
    void setRunningPlan(const QString& name, const std::string& text);
    /// "Put into the robot" can be asked for; else it is shown why not.
    void setApplicable(bool applicable, const QString& why_not = {});
    /// A plan that has no file yet; the history begins anew.
    void setText(const std::string& text, const QString& name);
    /// Where unsaved texts are kept over a crash; none are without. A new plan that was kept is offered at once.
    void setKeepingFolder(const QString& folder);
    /// The changes are given up for good: nothing is offered again.
    void forgetKept() { file_.forgetKept(); }

    Result<void> open(const QString& path);
    Result<void> save(const QString& path);
    /// What the other readers of POSH lack of this plan, a line each.
    Result<QStringList> exportTo(const QString& path, posh::Dialect dialect);
    /// .svg, .pdf or .png.
    Result<void> savePicture(const QString& path);

    const std::string& text() const { return text_->planText(); }
    QString path() const { return file_.path(); }
    QString name() const { return file_.name(); }
    bool isModified() const { return text_->document()->isModified(); }
    /// Of the text as it is now, those of binding too.
    const posh::Findings& findings();
    /// What can be done about the finding at the text's cursor.
    std::vector<posh::QuickFix> mends();

    PlanCanvas& canvas() { return *canvas_; }
    PlanCodeEdit& textEdit() { return *text_; }
    PlanPalette& palette() { return *palette_; }
    /// Every command by its name: "undo", "move_up", "wrap_pattern", …; a bug (assertion) for others.
    QAction* action(const QString& name) const;
    /// Text and drawing are brought in step at once, not in a moment.
    void catchUp();

    QSize sizeHint() const override { return {1280, 720}; }
    QSize minimumSizeHint() const override { return {300, 240}; }

signals:
    void openRequested();
    /// Also where "Save" has no file yet.
    void saveAsRequested();
    void exportRequested(usar::posh::Dialect dialect);
    void pictureRequested();
    /// Put this plan into the robot.
    void applyRequested(const std::string& text, const QString& name);
    void saved(const QString& path);
    /// By "Save": where it could not be written.
    void saveFailed(const usar::Error& error);
    /// Name or modified mark are others.
    void titleChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class InPlace { Words, Rename, Trigger, Limit, Comment };
    struct Command;

    // in plan_editor_parts.cpp
    QWidget* makeHead();
    QWidget* makeTextPane();
    QWidget* makeDrawingPane();
    QWidget* makeLists();
    QWidget* makeOffer();
    QListWidget* makeList(const QString& name, const QString& help);
    QToolButton* addButton(QBoxLayout* row, QAction* action);
    QToolButton* addMenuButton(QBoxLayout* row, const QString& help, const QString& icon_name, QMenu* menu);
    void arrange();

    // in plan_editor_commands.cpp
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
    /// Of any text; `plan` may be nullptr.
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
