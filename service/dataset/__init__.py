"""Datasets: homes by the thousand in files that training reads, on one machine or many.

Comes in: a request or how requests differ, a range of seeds. Goes out: a folder of tables, archives, a manifest and a card.
`dataset_plan` says what is made, `shards` makes a part of it, `building` all of it.
"""
