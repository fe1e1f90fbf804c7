#include "widgets/window/layout_keeper.h"

#include <utility>

#include "core/base/hand_over.h"
#include "widgets/panels/dialogs.h"
#include "widgets/window/dock_arranger.h"

namespace usar::widgets {

LayoutKeeper::LayoutKeeper(QMainWindow& window, CommandRegistry& commands, const QString& folder)
    : window_(window)
    , commands_(commands)
    , store_(folder) {
    disk_.setMaxThreadCount(1);
}

template <class T>
void LayoutKeeper::inPool(std::function<Result<T>()> work, std::function<void(const Result<T>&)> done) {
    disk_.start(HandedOver([this, work = std::move(work), done = std::move(done)] {
        QMetaObject::invokeMethod(this, HandedOver([done, result = work()] { done(result); }), Qt::QueuedConnection);
    }));
}

void LayoutKeeper::inPool(std::function<Result<void>()> work) {
    inPool<void>(std::move(work), [this](const Result<void>& done) {
        if (!done)
            complain(done.error());
    });
}

void LayoutKeeper::registerCommands() {
    commands_.add(commandSpec("view.layout_save"), [this](bool) {
        openDialog();
        dialog_->askForName();
    });
    commands_.add(commandSpec("view.layouts"), [this](bool) { openDialog(); });
    commands_.offer([this] {
        std::vector<PaletteOffer> offers;
        for (const auto& [name, layout] : layouts_)
            offers.push_back(
                {tr("Layout: %1").arg(name), tr("View"), {"arrange", "docks", "windows"}, [this, name = name] {
                     show(name);
                 }});
        return offers;
    });
}

void LayoutKeeper::read() {
    for (const QString& name : store_.names())
        inPool<DockLayout>([store = store_, name] { return store.read(name); },
                           [this](const Result<DockLayout>& layout) {
                               if (!layout)
                                   return complain(layout.error());
                               layouts_.emplace(layout->name, *layout);
                           });
}

void LayoutKeeper::fillMenu(QMenu* menu) {
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

void LayoutKeeper::addView(const QString& dock, std::function<QJsonObject()> save,
                           std::function<void(const QJsonObject&)> restore) {
    added_[dock] = {std::move(save), std::move(restore)};
}

void LayoutKeeper::openDialog() {
    if (!dialog_) {
        dialog_ = new LayoutDialog(&window_);
        dialog_->setAttribute(Qt::WA_DeleteOnClose);
        connectDialog();
        setLayouts(layouts_);
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void LayoutKeeper::connectDialog() {
    auto* const dialog = dialog_.data();
    connect(dialog, &LayoutDialog::saveRequested, this, &LayoutKeeper::save);
    connect(dialog, &LayoutDialog::showRequested, this, &LayoutKeeper::show);
    connect(dialog, &LayoutDialog::renameRequested, this, [this](const QString& from, const QString& to) {
        Layouts after = layouts_;
        auto node = after.extract(from);
        node.key() = node.mapped().name = to;
        after.insert(std::move(node));
        change(after, tr("rename layout %1").arg(from));
    });
    connect(dialog, &LayoutDialog::removeRequested, this, [this](const QString& name) {
        Layouts after = layouts_;
        after.erase(name);
        change(after, tr("delete layout %1").arg(name));
    });
    connect(dialog, &LayoutDialog::importRequested, this, [this] {
        askForFile(&window_, tr("Import layout"), {}, tr("Layouts (*.json)"),
                   [this](const QString& path) { importFrom(path); });
    });
    connect(dialog, &LayoutDialog::exportRequested, this, [this](const QString& name) {
        askWhereToSave(&window_, tr("Export layout"), name + ".json", tr("Layouts (*.json)"),
                       [this, layout = layouts_[name]](const QString& path) { exportTo(path, layout); });
    });
}

void LayoutKeeper::save(const QString& name) {
    DockLayout layout = layoutOf(window_);
    layout.name = name;
    for (const auto& [dock, view] : added_)
        layout.views[dock] = view.save();
    Layouts after = layouts_;
    after[name] = layout;
    change(after, tr("save layout %1").arg(name));
}

void LayoutKeeper::show(const QString& name) {
    const auto found = layouts_.find(name);
    if (found == layouts_.end())
        return;
    const DockLayout layout = found->second;
    rearrange(name, layout.views.keys(), [this, layout] {
        arrangeDocks(window_, layout);
        restoreViews(layout.views);
    });
}

void LayoutKeeper::rearrange(const QString& name, const std::function<void()>& arrange) {
    rearrange(name, {}, arrange);
}

void LayoutKeeper::rearrange(const QString& name, const QStringList& views, const std::function<void()>& arrange) {
    const DockState before = docks(views);
    arrange();
    emit docksEdited(tr("show layout %1").arg(name), before, docks(views));
}

DockState LayoutKeeper::docks(const QStringList& views) const {
    DockState state{window_.saveState(), {}};
    for (const auto& [dock, view] : added_)
        if (views.contains(dock))
            state.views[dock] = view.save();
    return state;
}

void LayoutKeeper::setDocks(const DockState& state) {
    window_.restoreState(state.docks);
    restoreViews(state.views);
}

void LayoutKeeper::restoreViews(const QJsonObject& views) {
    for (const auto& [dock, view] : added_)
        if (views.contains(dock))
            view.restore(views[dock].toObject());
}

void LayoutKeeper::importFrom(const QString& path) {
    inPool<DockLayout>([store = store_, path] { return store.import(path); },
                       [this](const Result<DockLayout>& layout) {
                           if (!layout)
                               return complain(layout.error());
                           Layouts after = layouts_;
                           after[layout->name] = *layout;
                           change(after, tr("import layout %1").arg(layout->name));
                       });
}

void LayoutKeeper::exportTo(const QString& path, const DockLayout& layout) {
    inPool([layout, path] { return LayoutStore::writeTo(layout, path); });
}

void LayoutKeeper::change(const Layouts& layouts, const QString& text) {
    const Layouts before = layouts_;
    setLayouts(layouts);
    emit layoutsEdited(text, before, layouts_);
}

void LayoutKeeper::setLayouts(const Layouts& layouts) {
    const Layouts before = std::exchange(layouts_, layouts);
    for (const auto& [name, layout] : layouts_)
        if (const auto old = before.find(name); old == before.end() || !(old->second == layout))
            inPool([store = store_, layout = layout] { return store.write(layout); });
    for (const auto& [name, layout] : before)
        if (!layouts_.contains(name))
            inPool([store = store_, name = name] { return store.remove(name); });
    if (!dialog_)
        return;
    QStringList names;
    for (const auto& [name, layout] : layouts_)
        names << name;
    dialog_->complain({});
    dialog_->setNames(names);
}

void LayoutKeeper::complain(const Error& error) {
    if (dialog_)
        dialog_->complain(QString::fromStdString(error.text()));
    emit failed(error);
}

} // namespace usar::widgets
