"""HTTP and command line, nothing else.

Comes in: HTTP requests, arguments, files. Goes out: documents, problem documents, exit statuses. May import: solver and
catalogs. Not here: rules, layout, formats; a handler reads, asks the solver once and writes.
"""
