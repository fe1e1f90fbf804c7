#include "app/desks/layout_desk.h"

#include <QFileInfo>

#include "core/base/hand_over.h"
#include "widgets/panels/dialogs.h"
#include "widgets/window/dock_arranger.h"

namespace usar::app {

LayoutDesk::LayoutDesk(const DeskContext& context, QMainWindow& window)
    : Desk(context)
    , main_window_(window)
    , store_(QFileInfo(QSettings().fileName()).path() + "/layouts") {
    disk_.setMaxThreadCount(1);
}

template <class T>
void LayoutDesk::inPool(std::function<Result<T>()> work, std::function<void(const Result<T>&)> done) {
    disk_.start(HandedOver([this, work = std::move(work), done = std::move(done)] {
        QMetaObject::invokeMethod(this, HandedOver([done, result = work()] { done(result); }), Qt::QueuedConnection);
    }));
}

void LayoutDesk::registerCommands() {
    add("view.layout_save", [this] {
        openDialog();
        dialog_->askForName();
    });
    add("view.layouts", [this] { openDialog(); });
    commands_.offer([this] {
        std::vector<widgets::PaletteOffer> offers;
        for (const auto& [name, layout] : layouts_)
            offers.push_back(
                {tr("Layout: %1").arg(name), tr("View"), {"arrange", "docks", "windows"}, [this, name = name] {
                     show(name);
                 }});
        return offers;
    });
}

void LayoutDesk::wire() {
    for (const QString& name : store_.names())
        inPool<widgets::DockLayout>([store = store_, name] { return store.read(name); },
                                    [this](const Result<widgets::DockLayout>& layout) {
                                        if (!layout)
                                            return complain(layout.error());
                                        layouts_.emplace(layout->name, *layout);
                                    });
}

void LayoutDesk::fillMenu(QMenu* menu) {
    menu->setToolTipsVisible(true);
    const QList<QAction*> own = menu->actions();
    connect(menu, &QMenu::aboutToShow, this, [this, menu, own] {
        for (QAction* const old : menu->actions())
            if (!own.contains(old))
                delete old;
        if (!layouts_.empty())
            menu->addSeparator();
        for (const auto& [name, layout] : layouts_)
            menu->addAction(QString(name).replace("&", "&&"), this, [this, name = name] { show(name); });
    });
}

void LayoutDesk::addView(const QString& dock, std::function<QJsonObject()> save,
                         std::function<void(const QJsonObject&)> restore) {
    added_[dock] = {std::move(save), std::move(restore)};
}

void LayoutDesk::openDialog() {
    if (!dialog_) {
        dialog_ = new widgets::LayoutDialog(&main_window_);
        dialog_->setAttribute(Qt::WA_DeleteOnClose);
        connectDialog();
        apply(layouts_);
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void LayoutDesk::connectDialog() {
    auto* const dialog = dialog_.data();
    connect(dialog, &widgets::LayoutDialog::saveRequested, this, &LayoutDesk::save);
    connect(dialog, &widgets::LayoutDialog::showRequested, this, &LayoutDesk::show);
    connect(dialog, &widgets::LayoutDialog::renameRequested, this, [this](const QString& from, const QString& to) {
        Layouts after = layouts_;
        auto node = after.extract(from);
        node.key() = node.mapped().name = to;
        after.insert(std::move(node));
        change(after, tr("rename layout %1").arg(from));
    });
    connect(dialog, &widgets::LayoutDialog::removeRequested, this, [this](const QString& name) {
        Layouts after = layouts_;
        after.erase(name);
        change(after, tr("delete layout %1").arg(name));
    });
    connect(dialog, &widgets::LayoutDialog::importRequested, this, [this] {
        widgets::askForFile(window_, tr("Import layout"), {}, tr("Layouts (*.json)"),
                            [this](const QString& path) { importFrom(path); });
    });
    connect(dialog, &widgets::LayoutDialog::exportRequested, this, [this](const QString& name) {
        const auto write = [this, layout = layouts_[name]](const QString& path) {
            inPool<void>([layout, path] { return widgets::LayoutStore::writeTo(layout, path); },
                         [this](const Result<void>& written) {
                             if (!written)
                                 complain(written.error());
                         });
        };
        widgets::askWhereToSave(window_, tr("Export layout"), name + ".json", tr("Layouts (*.json)"), write);
    });
}

void LayoutDesk::save(const QString& name) {
    widgets::DockLayout layout = widgets::layoutOf(main_window_);
    layout.name = name;
    for (const auto& [dock, view] : added_)
        layout.views[dock] = view.save();
    Layouts after = layouts_;
    after[name] = layout;
    change(after, tr("save layout %1").arg(name));
}

void LayoutDesk::show(const QString& name) {
    const auto found = layouts_.find(name);
    if (found == layouts_.end())
        return;
    const widgets::DockLayout layout = found->second;
    rearrange(name, [this, layout] {
        widgets::arrangeDocks(main_window_, layout);
        for (const auto& [dock, view] : added_)
            if (layout.views.contains(dock))
                view.restore(layout.views[dock].toObject());
    });
}

void LayoutDesk::rearrange(const QString& name, const std::function<void()>& arrange) {
    const QByteArray before = main_window_.saveState();
    arrange();
    const auto restore = [this](const QByteArray& state) { main_window_.restoreState(state); };
    control_.history().endStep();
    control_.history().add(mission::valueEdit<QByteArray>("layout", tr("show layout %1").arg(name), before,
                                                          main_window_.saveState(), restore));
    control_.history().endStep();
}

void LayoutDesk::importFrom(const QString& path) {
    inPool<widgets::DockLayout>([store = store_, path] { return store.import(path); },
                                [this](const Result<widgets::DockLayout>& layout) {
                                    if (!layout)
                                        return complain(layout.error());
                                    Layouts after = layouts_;
                                    after[layout->name] = *layout;
                                    change(after, tr("import layout %1").arg(layout->name));
                                });
}

void LayoutDesk::change(const Layouts& layouts, const QString& text) {
    const Layouts before = layouts_;
    apply(layouts);
    control_.history().endStep();
    control_.history().add(
        mission::valueEdit<Layouts>("layouts", text, before, layouts, [this](const Layouts& now) { apply(now); }));
    control_.history().endStep();
}

void LayoutDesk::apply(const Layouts& layouts) {
    const auto report = [this](const Result<void>& done) {
        if (!done)
            complain(done.error());
    };
    for (const auto& [name, layout] : layouts)
        if (const auto old = layouts_.find(name); old == layouts_.end() || !(old->second == layout))
            inPool<void>([store = store_, layout = layout] { return store.write(layout); }, report);
    for (const auto& [name, layout] : layouts_)
        if (!layouts.contains(name))
            inPool<void>([store = store_, name = name] { return store.remove(name); }, report);
    layouts_ = layouts;
    if (!dialog_)
        return;
    QStringList names;
    for (const auto& [name, layout] : layouts_)
        names << name;
    dialog_->complain({});
    dialog_->setNames(names);
}

void LayoutDesk::complain(const Error& error) {
    notices_.complain("layout", error);
    if (dialog_)
        dialog_->complain(QString::fromStdString(error.text()));
}

} // namespace usar::app
