// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/module_loader.h"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdlib>
#include <vector>

#include "afx/file.h"

namespace afx {
namespace {

std::vector<std::string> module_folders() {
  std::vector<std::string> folders;
  if (const char* given = ::secure_getenv("AFX_MODULE_DIR"); given != nullptr && *given != 0)
    folders.emplace_back(given);
  std::array<char, PATH_MAX> program{};
  const ssize_t length = ::readlink("/proc/self/exe", program.data(), program.size() - 1);
  if (length > 0)
    folders.push_back(folder_of(std::string(program.data(), static_cast<size_t>(length))) +
                      "/../lib/afx");
  Dl_info here{};
  if (::dladdr(reinterpret_cast<const void*>(&module_folders), &here) != 0 &&
      here.dli_fname != nullptr)
    folders.push_back(folder_of(here.dli_fname) + "/afx");
#ifdef AFX_MODULE_INSTALL_DIR
  folders.emplace_back(AFX_MODULE_INSTALL_DIR);
#endif
  return folders;
}

}  // namespace

ModuleSymbol find_in_module(const std::string& name, const char* symbol, const std::string& what) {
  std::string looked;
  for (const std::string& folder : module_folders()) {
    const std::string path = folder + "/" + name + ".so";
    looked += (looked.empty() ? "" : ", ") + folder;
    if (::access(path.c_str(), F_OK) != 0) continue;
    void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* found = library == nullptr ? nullptr : ::dlsym(library, symbol);
    if (found != nullptr) return {found, {}};
    const char* reason = ::dlerror();
    return {nullptr, what + " cannot be loaded: " + std::string(reason ? reason : path)};
  }
  return {nullptr, what + ", " + name + ".so, is not there (looked in " + looked + ")"};
}

}  // namespace afx
